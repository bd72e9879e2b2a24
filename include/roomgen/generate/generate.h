#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/design/designer.h"
#include "roomgen/library/library.h"
#include "roomgen/scene/dwelling.h"
#include "roomgen/scene/model_table.h"
#include "roomgen/scene/plan.h"
#include "roomgen/scene/scene.h"
#include "roomgen/solve/place.h"
#include "roomgen/view/view.h"

namespace roomgen {

/// What the step loop reports before each object, for a progress bar.
struct StepProgress {
  std::size_t step = 0;   ///< from 0
  std::size_t total = 0;
  std::string object;     ///< id, or "improving" at the end
};

struct GenerateOptions {
  PlaceOptions place;
  int assets_per_object = 3;   ///< assets that are tried before the designer is asked again
  int answers_per_object = 3;  ///< times the designer is asked for one object
  int repair_rounds = 12;      ///< of improvement for one object that found no place
  int improve_rounds = 60;     ///< of improvement at the end
  std::uint64_t seed = 0;      ///< which of equally good assets are taken
  CancelToken cancel;
  std::function<void(const StepProgress&)> on_step;
  /// Draws what the designer sees; may be null.
  Renderer* renderer = nullptr;
  View marks_view{View::Kind::top, 1024, true, false};
};

/// What became of one planned object: a line of trace.jsonl.
struct Step {
  PlannedObject planned;
  Json record;  ///< what was asked, answered, proposed and chosen (docs/trace.md)
};

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

struct Generation {
  Scene scene;
  ModelTable models;  ///< of all openings and all objects placed
  std::vector<AssetInfo> assets;  ///< of all openings and all objects placed, without repetition
  std::vector<Step> trace;
  int constraints = 0;
  int held = 0;
  SuggestionFigures suggestions;
  ModelUse model_use;
  std::vector<std::string> notes;  ///< which objects are only stand-ins, for people
  std::string stopped;  ///< why the designer was not asked any more, if so
};

/// Furnishes a room step by step: for each planned object retrieve an asset, ask the designer, propose,
/// score, fuse, place; when it does not fit, the next asset, then the designer again with the reason, then
/// a repair, then it is left out with the reason. A last improvement wins back what was lost.
/// One object that fails never costs another its place. When cancelled, or when the designer may ask no more
/// (Error::Kind::limit), what is placed so far is returned and the scene is marked incomplete.
Result<Generation> generate(const Plan& plan, Designer& designer, const AssetLibrary& library,
                            const KindTable& categories, const GenerateOptions& options = {});

/// Furnishes the rooms of a dwelling one after the other into one scene. What was stopped in one
/// room is stopped in those after it.
Result<Generation> generate(const DwellingPlan& plan, Designer& designer,
                            const AssetLibrary& library, const KindTable& categories,
                            const GenerateOptions& options = {});

}  // namespace roomgen
