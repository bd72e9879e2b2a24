#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/room.h"

namespace roomgen::lab {

// A room described by constraints and scores: how many things of which kinds, how each is put up
// against what, and what makes one arrangement better than another (docs/programs.md; after the
// constraint language of Infinigen Indoors, Raistrick et al., CVPR 2024, as InfiniBench's supplement,
// section A, uses it). This header is the document alone; roomgen/optimise/optimise.h gives it a meaning
// and finds rooms for it.

/// A number, or an interval: both ends belong to it.
struct Range {
  double low = 0.0;
  double high = 0.0;

  bool operator==(const Range&) const = default;
};

/// A side of a thing in its own frame (front towards -Y), or of the room.
enum class Face { front, back, left, right, top, bottom, support, wall, floor, ceiling };

/// How a thing is put up: some face of it against some face of another thing or of the room.
/// `stable_against`: the faces are parallel and `margin` apart, and the child's, seen along the normal, lies
/// on the parent's (with `within_height` unset only its extent along the floor does).
/// `coplanar`: the faces lie in one plane, `margin` apart, and look the same way.
struct PutUp {
  enum class Type { stable_against, coplanar };
  Type type = Type::stable_against;
  std::vector<Face> child;   ///< any one of these
  std::vector<Face> parent;  ///< any one of these
  double margin = 0.0;       ///< metres
  bool within_height = true; ///< "check_z"

  bool operator==(const PutUp&) const = default;
};

struct ProgramSet;

/// "on_floor room": what members of a set are to something.
struct SetRelation {
  bool absent = false;  ///< "-on_floor": what is not so
  std::string relation; ///< name of a PutUp; "any" for each of them
  std::vector<ProgramSet> target;  ///< one; a vector because it may be described in place

  bool operator==(const SetRelation&) const;
};

/// Things of the room. Which things these are depends on their kinds and on how they are put up (what an
/// object was made to stand against), never on where they happen to be.
struct ProgramSet {
  enum class Source {
    objects,  ///< all things
    room,     ///< the room itself
    doors,    ///< passages too
    windows,
    named,      ///< one of the program's sets: `name`
    variable,   ///< what all, mean and sum run over: `name`
    described,  ///< members of `from` (else of objects) with all of the below
    united,     ///< members of any of `from`
  };
  Source source = Source::objects;
  std::string name = {};
  std::vector<ProgramSet> from = {};      ///< described: at most one
  std::vector<std::string> tags = {};     ///< "storage"; all of them
  std::vector<std::string> without = {};  ///< tags that they have not ("-storage")
  std::string factory = {};               ///< a kind of thing; empty: any
  std::vector<SetRelation> relations = {};
  std::string at = {};  ///< JSON pointer of where it was read; empty if it was built

  bool operator==(const ProgramSet& other) const;  ///< wherever they stand
};

/// What an expression does. Each is defined where the optimiser computes it (optimise/optimise.h).
enum class ProgramOp {
  // Numbers; "N": a number.
  constant, parameter,
  count, footprint, volume, area, occupancy, seats,
  distance, gap, access, angle, focus, center, reflection, rotation, coplanarity,
  add, multiply, subtract, divide, power, absolute, logarithm, least, greatest, clamp, hinge,
  mean, sum, minimize, maximize,
  // Truths; "B": a truth.
  all_of, any_of, not_of, for_all, within, equal, unequal, at_least, at_most, more, less,
};

/// What the operators take, for readers, checkers, printers and whoever shows a model the language.
struct ProgramOpForm {
  ProgramOp op;
  std::string_view name;      ///< in files: "dist"
  /// Operands in order: S a set, N a number, B a truth, L a literal number, v a variable's name, s a
  /// face or nothing, a the {"dir","depth"} of access or nothing; "+" after the last: one or more of it.
  std::string_view operands;
  bool truth = false;         ///< yields a truth, else a number
  std::string_view meaning;   ///< one sentence
};
/// All of them but constant and parameter, which have no name.
const std::vector<ProgramOpForm>& program_op_forms();
const ProgramOpForm* find_op_form(std::string_view name);
const ProgramOpForm& form_of(ProgramOp op);

/// A number or a truth.
struct ProgramTerm {
  ProgramOp op = ProgramOp::constant;
  double number = 0.0;        ///< of a constant; the weight of minimize and maximize
  std::string name = {};      ///< of a parameter, without "@"; the variable of for_all, mean and sum, without "$"
  std::vector<ProgramSet> sets = {};
  std::vector<ProgramTerm> operands = {};
  std::vector<double> literals = {};     ///< low and high of within, hinge and clamp
  std::optional<Face> face = {};         ///< of dist and angle: of the second set's members
  std::string direction = "front";       ///< of access: front, back, left, right, up, down, sides (left and right)
  double depth = 1.0;                    ///< of access, metres
  std::string at = {};                   ///< JSON pointer; empty if it was built

  bool operator==(const ProgramTerm& other) const;  ///< wherever they stand
};

/// A number that is drawn once, from the seed.
struct ProgramParameter {
  std::optional<Range> uniform = {};
  std::vector<double> choice = {};  ///< one of these, if not uniform
  bool operator==(const ProgramParameter&) const = default;
};

/// The room that is asked for: an outline, else width and depth or an area, each a number or a range; nothing:
/// as large as such rooms are.
struct ProgramRoom {
  std::string type;                          ///< "dining room"; hyphens read as spaces
  std::optional<Polygon> polygon = {};
  std::optional<Range> width = {}, depth = {}, area = {};
  std::optional<double> height = {};
  std::optional<std::vector<Opening>> openings = {};  ///< of a given polygon or a fixed size; else they are planned
};

/// Named expressions keep the order of the file.
using NamedSets = std::vector<std::pair<std::string, ProgramSet>>;
using NamedTerms = std::vector<std::pair<std::string, ProgramTerm>>;

struct ConstraintProgram {
  std::string prompt = {};  ///< what it was made from, if it was
  std::uint64_t seed = 0;
  ProgramRoom room = {};
  std::map<std::string, ProgramParameter> parameters = {};
  std::map<std::string, PutUp> relations = {};  ///< besides the built-in ones
  NamedSets sets = {};
  NamedTerms constraints = {};  ///< truths
  NamedTerms scores = {};       ///< numbers; what minimize and maximize say is wanted
  std::string source = {};      ///< the file, for messages
};

/// "on_floor", "against_wall", "front_against" and so on (docs/programs.md); the margins of the source
/// (Infinigen Indoors' constraint utilities).
const std::map<std::string, PutUp, std::less<>>& built_in_relations();

/// program.json (docs/program.schema.json): {"format": "roomgen-program", "version": 1, ...}; the format may
/// be left out. Errors give the JSON pointer.
Result<ConstraintProgram> program_from_json(const Json& json, const std::string& source);
Result<ConstraintProgram> read_program(const std::filesystem::path& path);
bool is_program(const Json& json);
Json to_json(const ConstraintProgram& program);
/// For people: one line a set, a constraint, a score, in words.
std::string to_text(const ConstraintProgram& program);
std::string to_text(const ProgramTerm& term);
std::string to_text(const ProgramSet& set);

/// Words that programs use for things: tags and factories, as kinds (data/program/vocabulary.json).
struct ProgramVocabulary {
  /// Kinds that a tag covers, with their descendants; "-desk": without that kind and its descendants. Of a
  /// thing's kind and its ancestors the nearest one that is listed decides; ask has_tag() and is_made_by().
  std::map<std::string, std::vector<std::string>, std::less<>> tags;
  /// Kinds that a factory makes, likewise; the names of all kinds are factories too ("dining_table").
  std::map<std::string, std::vector<std::string>, std::less<>> factories;
  /// How many people sit on things of a kind and its descendants: so many, or one for so many metres of width.
  struct Sitters {
    int people = 0;
    double metres = 0.0;  ///< 0: `people`, whatever the width
  };
  std::map<std::string, Sitters, std::less<>> seats;

  static const ProgramVocabulary& built_in();
};
/// How many people can sit on a thing of this kind and width; of the kind and its ancestors the nearest that is listed decides.
int seats_on(const ProgramVocabulary& vocabulary, const Kind& kind, double width);
bool has_tag(const ProgramVocabulary& vocabulary, const Kind& kind, std::string_view tag);
/// Is the thing's kind one that the factory makes?
bool is_made_by(const ProgramVocabulary& vocabulary, const KindTable& kinds, const Kind& kind, std::string_view factory);

/// One finding about a program.
struct ProgramFinding {
  enum class Severity { error, warning };
  Severity severity = Severity::error;
  std::string at;       ///< JSON pointer
  std::string message;  ///< what and what to do
};

/// What is wrong or doubtful: names of tags, factories, sets, variables, parameters and relations that nobody
/// knows, operands of the wrong sort, sets that name themselves, counts without an upper bound, bounds that
/// contradict each other, more footprint than floor. Errors make a program useless.
std::vector<ProgramFinding> check(const ConstraintProgram& program, const KindTable& kinds,
                                  const ProgramVocabulary& vocabulary = ProgramVocabulary::built_in());

/// How many members of a set a program allows.
struct CountBound {
  const ProgramSet* set = nullptr;  ///< of the program
  double low = 0.0;
  double high = 0.0;                ///< infinity if there is none
  /// The variables that are in force there, outermost first, with the sets that they run over.
  std::vector<std::pair<std::string, const ProgramSet*>> variables = {};
};
/// The bounds that the constraints set on counts, wherever all parts of a conjunction must hold. What
/// is in no bound's set is never added to a room.
std::vector<CountBound> count_bounds(const ConstraintProgram& program);

// For programs written in C++:
//
//     using namespace roomgen::programs;
//     ProgramSet chairs = with(of_kind("chair"), "front_against", variable("t"));
//     ProgramTerm seated = for_all("t", set("table"), within(count(chairs), 3, 6));
namespace programs {
ProgramSet things();
ProgramSet room();
ProgramSet doors();
ProgramSet windows();
ProgramSet set(std::string name);
ProgramSet variable(std::string name);
ProgramSet tagged(std::string tag);
ProgramSet of_kind(std::string factory);
/// The members of `of`, instead of those that it chose from, that are as the description says.
ProgramSet among(ProgramSet of, ProgramSet description);
ProgramSet either(std::vector<ProgramSet> sets);
/// Those that are put up so against a member of the target; `relation` may be "any".
ProgramSet with(ProgramSet set, std::string relation, ProgramSet target);
ProgramSet without(ProgramSet set, std::string relation, ProgramSet target);

ProgramTerm number(double value);
ProgramTerm parameter(std::string name);
ProgramTerm count(ProgramSet set);
/// Any operator by what it takes; the typed ones above and below are for what is frequent.
ProgramTerm term(ProgramOp op, std::vector<ProgramSet> sets, std::vector<ProgramTerm> operands = {});
ProgramTerm distance(ProgramSet from, ProgramSet to, std::optional<Face> face = {});
ProgramTerm within(ProgramTerm value, double low, double high);
ProgramTerm for_all(std::string variable, ProgramSet set, ProgramTerm truth);
ProgramTerm mean(std::string variable, ProgramSet set, ProgramTerm value);
ProgramTerm minimize(double weight, ProgramTerm value);
ProgramTerm maximize(double weight, ProgramTerm value);
ProgramTerm operator&&(ProgramTerm a, ProgramTerm b);
ProgramTerm operator||(ProgramTerm a, ProgramTerm b);
ProgramTerm operator+(ProgramTerm a, ProgramTerm b);
ProgramTerm operator-(ProgramTerm a, ProgramTerm b);
}  // namespace programs

}  // namespace roomgen::lab
