#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/chat/chat_model.h"
#include "roomgen/library/library.h"
#include "roomgen/lab/optimise.h"
#include "roomgen/lab/program.h"
#include "roomgen/scene/plan.h"

namespace roomgen::lab {

/// How much a room shall hold, as far as somebody says: ranges with both bounds included. The measures of
/// InfiniBench's experiments (compositional: objects, seats, shelves; relational: occupancy).
struct Complexity {
  std::optional<Range> objects;    ///< all things of the room
  std::optional<Range> seats;      ///< people who can sit
  std::optional<Range> shelves;    ///< bookcases and other pieces with shelves
  std::optional<Range> occupancy;  ///< of the floor, all but rugs; a share

  bool empty() const { return !objects && !seats && !shelves && !occupancy; }
};
/// A name of each measure, as options, reports and files have it: objects, seats, shelves, occupancy.
struct ComplexityMeasure {
  const char* name;
  std::optional<Range> Complexity::*range;
};
const std::vector<ComplexityMeasure>& complexity_measures();

/// What an English text says of it: "seating for 12", "about half of the floor", "many shelves"
/// (data/program/complexity.json). "About" reaches 20 % of a number and 5 points of a share to either side; a share
/// that is said as one number is met within 3 points.
Complexity complexity_of(std::string_view text);
/// "20..25", "0.4..0.5", "12": both bounds may be left out ("..10"). Shares also as "40%". More than `most` is refused.
Result<Range> range_from(std::string_view text, const std::string& option, double most = 1e4);
/// The most that can be asked for of a measure: of shares 1.
double most_of_measure(std::string_view measure);
/// "8 to 12", "at least 3"
std::string range_text(const Range& range);
/// That of `asked`, with what `told` says instead where it says anything.
Complexity overridden(Complexity asked, const Complexity& told);

/// A program that was written for a prompt, with what it takes to run it.
struct WrittenProgram {
  ConstraintProgram program;
  std::vector<StockWish> stock;  ///< the kinds that it may add, as the prompt describes them
  Plan plan;               ///< what the prompt was understood as: the room, its requirements
  Complexity asked;        ///< the prompt's and the request's
  bool is_room_free = false;  ///< nobody gave the room's size: it may become another
  std::vector<std::string> notes;
};

/// What a program is to be written for.
struct ComposeRequest {
  PlanRequest plan;      ///< prompt, seed, a given room or size
  Complexity complexity; ///< beside and before what the prompt says
};

/// By rules: what the prompt asks for and what such rooms usually hold (the rule designer's plan) becomes sets, counts
/// and ways of being put up; how things of a kind stand to each other becomes scores.
Result<WrittenProgram> write_program(const ComposeRequest& request);

/// A measure that was asked for, and what the room has.
struct MeasureVerdict {
  std::string name;
  Range asked;
  double reached = 0.0;
  double missed = 0.0;  ///< 0: reached
};

/// What is wrong with a room that was made by a program.
struct ErrorReport {
  std::vector<ConstraintVerdict> unmet;   ///< the program's constraints that do not hold
  std::vector<MeasureVerdict> measures;   ///< of the complexity that was asked for
  std::vector<std::string> colliding;     ///< "chair-0 and desk-1": pairs whose meshes share space
  std::size_t things = 0;
  double occupancy = 0.0;
  double violation = 0.0;                 ///< the sum of what constraints miss
  std::map<std::string, int> counts;      ///< things of each kind
  /// Names of constraints that cannot be had together, as far as conflict() tells; empty if nobody looked.
  std::vector<std::string> conflict;

  bool is_met() const;
  /// The less, the better: what constraints miss, and 1 for each measure that is missed.
  double missed_in_all() const;
};
ErrorReport error_report(const Optimisation& result, const Complexity& asked, const ModelTable& models,
                         const KindTable& kinds);
Json to_json(const ErrorReport& report);
/// For people and models: a line each.
std::string to_text(const ErrorReport& report);

/// What a room has of a measure, by its name: people who can sit, pieces with shelves, things, or `occupancy` itself.
double measured(std::string_view measure, const Scene& scene, double occupancy, const KindTable& kinds);

/// One change of a program.
struct Revision {
  WrittenProgram written;
  std::string reason;  ///< what was changed and why, for people
  Json patch;          ///< RFC 6902, from the program before to this one
  int rule = 0;        ///< which of the rules made it, from 1; 0: none
};
/// By rules, beginning behind the rule that made the last revision (0: none): a floor that suits the occupancy; what
/// finds no wall stands freely, and anywhere if none of it found a place; a larger room if nobody gave its size; without
/// what nobody asked for; more of what may be added; smaller things; weaker scores; the last is followed by the first.
/// Nothing if the report is met or nothing is left to try.
std::optional<Revision> revise(const WrittenProgram& written, const ErrorReport& report, int last_rule);

/// One round of writing, optimising and judging.
struct ComposeRound {
  WrittenProgram written;
  std::string reason;  ///< of the revision; empty in the first round
  Json patch;          ///< of the revision; null in the first round
  int rule = 0;        ///< of the revision
  Optimisation result;
  ModelTable models;   ///< the meshes of the result
  ErrorReport report;
  std::string picture; ///< PNG: what the author is shown of the room; empty if nobody draws it
};

/// Who writes and revises programs: rules, or a language model.
struct ProgramAuthor {
  std::string name;
  std::function<Result<WrittenProgram>(const ComposeRequest&)> write;
  /// Of the rounds so far; nothing when there is nothing left to try.
  std::function<Result<std::optional<Revision>>(const std::vector<ComposeRound>&)> revise;
  bool wants_conflict = false;  ///< the report shall name constraints that cannot be had together: takes searches
};
ProgramAuthor rule_author();

/// A kind that the opened libraries hold, and how large it usually is there.
struct KindOffer {
  std::string kind;
  Vec3 size;  ///< metres
};
struct ModelAuthorOptions {
  int answers = 3;          ///< asked for at most, for one program
  int max_tokens = 8192;    ///< of an answer
  int thinking = 0;         ///< tokens to think before each answer: ChatRequest::thinking
  std::vector<KindOffer> kinds;
};
/// A language model that is shown the language, the kinds, three examples, and for a revision the error report with a
/// picture of the room. It answers a program, or a patch of the last one. `model` must outlive the author, which is for
/// one composition at a time. Errors are those of chat, and invalid_input when no answer could be used.
ProgramAuthor model_author(ChatModel& model, Prompts prompts, ModelAuthorOptions options);

/// The index of the round that misses least; of equals the first. Precondition: there is one.
std::size_t best_of(std::span<const ComposeRound> rounds);

struct ComposeOptions {
  int rounds = 5;               ///< at most; 1: without refinement
  std::size_t assets_each = 3;  ///< meshes of each kind to choose from
  OptimiseOptions optimise;     ///< of each round
  std::function<Result<std::string>(const Scene&, const ModelTable&)> picture = {};
  std::function<void(const ComposeRound&)> on_round = {};
};

struct Composition {
  std::vector<ComposeRound> rounds;
  std::size_t best = 0;  ///< best_of() them
  std::vector<std::string> notes;

  const ComposeRound& chosen() const { return rounds[best]; }
};

/// A room for a sentence by a constraint program: written, optimised, judged, and revised from the error report until
/// it is met or the rounds are spent (InfiniBench's supplement, section B).
Result<Composition> compose_room(const ComposeRequest& request, const ProgramAuthor& author,
                                 const AssetLibrary& library, const KindTable& kinds,
                                 const ComposeOptions& options = {});

}  // namespace roomgen::lab
