#pragma once

#include <string>
#include <vector>

#include "attachment.h"
#include "base/random.h"
#include "lab/program/limits.h"
#include "roomgen/lab/program.h"
#include "roomgen/scene/relation.h"
#include "world.h"

namespace roomgen::lab::annealing {

/// The relations that a program may use, by number.
struct Language {
  std::vector<std::string> names;
  std::vector<PutUp> relations;

  int number_of(std::string_view name) const;  ///< -1 if there is none
};

/// Is everything put up as `special` says also put up as `general` says? The faces of the one are among those of the
/// other (a top is a support), at the same margin.
bool implies(const PutUp& special, const PutUp& general);

inline constexpr std::size_t most_variables = program_limits::variables;

/// A set with its names resolved.
struct SetNode {
  ProgramSet::Source source = ProgramSet::Source::objects;
  int variable = -1;          ///< index of the variable in force
  std::vector<int> from;      ///< sets
  int filter = -1;            ///< of tags and factory
  struct Relation {
    bool absent = false;
    std::vector<char> kinds;  ///< by number of relation: does it count?
    std::vector<int> wanted;  ///< numbers that may be used to put something up so, the plainest first
    int target = 0;           ///< a set
  };
  std::vector<Relation> relations;
  bool is_closed = true;      ///< depends on no variable
};

/// Which kinds have all tags and the factory of a set.
struct KindFilter {
  std::vector<char> passes;   ///< by number of kind
};

/// A number or a truth with its names resolved.
struct TermNode {
  ProgramOp op = ProgramOp::constant;
  double number = 0.0;
  int variable = -1;
  std::vector<int> sets;
  std::vector<TermNode> operands;
  double low = 0.0, high = 0.0;
  std::optional<Face> face;
  std::vector<Face> directions;
  double depth = 1.0;
  int memo = -1;              ///< of pairs, for access
  int structure_memo = -1;    ///< of what depends on no pose and on no variable in force
};

struct NamedTerm {
  std::string name;
  TermNode term;
  std::string text;  ///< as people read it
};

/// A single thing, the only one of its kind number, that is wanted with relations of scene/judgement.
struct Tie {
  int kind_number = 0;
  double missing = 1.0;               ///< what it counts that the thing is not there
  std::vector<Relation> relations;
  std::vector<int> targets;           ///< ties that the relations name; -1 for parts of the room
  std::vector<double> lost;           ///< what it counts that a relation does not hold
};

/// A program made ready for one room and one stock of kinds.
struct Compiled {
  Language language;
  std::vector<SetNode> sets;
  std::vector<KindFilter> filters;
  std::vector<NamedTerm> constraints;
  std::vector<NamedTerm> scores;
  std::vector<Tie> ties;
  int access_memos = 0;
  int structure_memos = 0;
};

/// Draws the parameters from `random`. Precondition: check() finds no error in the program.
class Compiler {
 public:
  /// `kinds` are those of the stock, by number.
  Compiler(const ConstraintProgram& program, const std::vector<const Kind*>& kinds, const KindTable& table,
           const ProgramVocabulary& vocabulary, Random random);
  void compile();
  const Compiled& compiled() const { return result_; }
  /// A set of the program within the scope of variables, as the compiled program's set.
  int set(const ProgramSet& set, const std::vector<std::string>& scope);
  /// What was compiled, with all sets asked for since.
  Compiled take() { return std::move(result_); }

 private:
  int described(const ProgramSet& set, const std::vector<std::string>& scope);
  int filter(const ProgramSet& set);
  SetNode::Relation relation(const SetRelation& relation, const std::vector<std::string>& scope);
  TermNode term(const ProgramTerm& term, std::vector<std::string> scope);

  const ConstraintProgram& program_;
  const std::vector<const Kind*>& kinds_;
  const KindTable& table_;
  const ProgramVocabulary& vocabulary_;
  std::map<std::string, double> parameters_;
  std::map<std::string, int> named_;
  Compiled result_;
};

}  // namespace roomgen::lab::annealing
