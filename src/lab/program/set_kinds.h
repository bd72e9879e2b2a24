#pragma once

#include <map>
#include <string>
#include <vector>

#include "roomgen/lab/program.h"

namespace roomgen::lab {

/// Which kinds of things can be in which sets of a program whose names have all been checked.
class SetKinds {
 public:
  /// One for each kind, in order of their names, and one more for the room, its doors and its windows.
  using Mask = std::vector<char>;

  /// All must outlive this.
  SetKinds(const ConstraintProgram& program, const KindTable& kinds, const ProgramVocabulary& vocabulary);

  /// What a variable runs over while its expression is looked at; variables are taken back in turn.
  void bind(const std::string& variable, const ProgramSet& set) {
    variables_.push_back({variable, &set, of(set)});
  }
  void unbind() { variables_.pop_back(); }

  /// What its members can be.
  Mask of(const ProgramSet& set);
  /// Can nothing be a member?
  bool is_empty(const ProgramSet& set);
  /// Is it the room, by whatever name?
  bool is_room(const ProgramSet& set) const;
  const std::vector<const Kind*>& kinds() const { return kinds_; }
  /// What a set's name stands for; null if nothing does.
  const ProgramSet* named(const std::string& name) const;

 private:
  using Memo = std::map<std::string, Mask, std::less<>>;

  template <typename Test>
  const Mask& remembered(Memo& memo, const std::string& word, Test test);
  const Mask& tagged(const std::string& tag);
  const Mask& made_by(const std::string& factory);
  const Mask& mounted(Mount mount);
  Mask nothing() const;
  Mask all_things() const;
  Mask described(const ProgramSet& set);
  Mask united(const ProgramSet& set);
  Mask of_name(const std::string& name);
  void keep_mountable(const SetRelation& relation, Mask& mask);
  const PutUp* relation(const std::string& name) const;
  struct Variable {
    std::string name;
    const ProgramSet* set = nullptr;
    Mask kinds;  ///< found once: sets of variables of sets of variables multiply
  };
  const Variable* bound(const std::string& variable) const;

  const ConstraintProgram& program_;
  const KindTable& table_;
  const ProgramVocabulary& vocabulary_;
  std::vector<const Kind*> kinds_;
  std::map<std::string, const ProgramSet*, std::less<>> sets_;
  std::vector<Variable> variables_;
  Memo tags_, factories_, mounts_, names_;
};

}  // namespace roomgen::lab
