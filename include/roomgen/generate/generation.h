#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomgen/base/json_fwd.h"
#include "roomgen/design/designer.h"
#include "roomgen/library/library.h"
#include "roomgen/scene/model_table.h"
#include "roomgen/scene/plan.h"
#include "roomgen/scene/scene.h"
#include "roomgen/solve/place.h"

namespace roomgen {

/// One asset with one answer of the designer, and what became of it.
struct Attempt {
  std::string asset;       ///< asset_key()
  PlaceAdvice answer;      ///< of the designer, or of the host
  int candidates = 0;      ///< poses proposed
  int feasible = 0;        ///< of them, inside the room and clear of other things
  std::optional<PlacementTerms> chosen;     ///< of the pose taken
  std::optional<PlacementTerms> runner_up;  ///< of the best other one
  bool made_room = false;  ///< what stood on the same support was arranged anew for it
  std::string refused;     ///< why no pose could be taken; empty: one was
};

/// A thing that an improvement or a repair put elsewhere.
struct Move {
  std::string object;
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< bottom centre
  double turn = 0.0;                            ///< radians, counter-clockwise

  double distance() const { return (to - from).norm(); }
};

/// What became of one planned object: a line of trace.jsonl (docs/trace.md).
struct Step {
  PlannedObject planned;
  std::string category, description;  ///< what retrieval was asked for
  bool has_assets = false;            ///< it found something to try
  std::vector<Attempt> attempts;      ///< in order
  std::string window;                 ///< the one that a curtain or blind covers
  std::optional<Pose> pose;           ///< where it stood at the end of the step
  bool repaired = false;              ///< neighbours made way
  std::vector<Move> moved;            ///< those neighbours
  std::string reason;                 ///< why it has no place; empty: it has one
  std::string room;                   ///< of a dwelling
  double seconds = 0.0;               ///< that the step took; not part of the trace
};

/// One line of trace.jsonl. Nothing in it depends on the clock.
Json to_json(const Step& step);
/// {"object", "from", "to", "by", "turned_deg"}: metres and degrees.
Json to_json(const Move& move);

/// How closely suggestions were followed (papers: RoomGen, table 3): numbers of objects in the finished
/// scene.
struct SuggestionFigures {
  int located = 0;      ///< placed, and a location was suggested
  int within_half = 0;  ///< of them, 0.5 m from it at most
  int within_one = 0;   ///< 1 m at most
  int faced = 0;        ///< placed, and a yaw was suggested
  int facing_kept = 0;  ///< of them, 15 degrees from it at most
};

/// What was asked of a language model while placing; zero for rules.
struct ModelUse {
  int calls = 0;
  long long input_tokens = 0;
  long long output_tokens = 0;
  double seconds = 0.0;
  int fallbacks = 0;  ///< objects for which rules decided in the end
};

/// A furnished room, or dwelling, and how it came about.
struct Generation {
  Scene scene;  ///< in the plan's order, with the requirements' verdicts; incomplete if it was stopped
  ModelTable models;  ///< of all openings and all objects placed
  std::vector<AssetInfo> assets;  ///< of all openings and all objects placed, without repetition
  std::vector<Step> trace;        ///< one a planned object that was tried, in order
  std::vector<Move> moved;        ///< by the improvement at the end
  int constraints = 0;
  int held = 0;
  SuggestionFigures suggestions;
  ModelUse model_use;
  std::vector<std::string> notes;  ///< which objects are only stand-ins, for people
  std::string stopped;  ///< why the designer was not asked any more, if so
};

}  // namespace roomgen
