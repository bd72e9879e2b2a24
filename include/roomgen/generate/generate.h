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

struct Generation {
  Scene scene;
  ModelTable models;  ///< of all objects placed
  std::vector<AssetInfo> assets;  ///< of all objects placed, without repetition
  std::vector<Step> trace;
  int constraints = 0;
  int held = 0;
};

/// Furnishes a room step by step: for each planned object retrieve an asset, ask the designer, propose,
/// score, fuse, place; when it does not fit, the next asset, then the designer again with the reason, then
/// a repair, then it is left out with the reason. A last improvement wins back what was lost.
/// One object that fails never costs another its place. When cancelled, what is placed so far is returned
/// and the scene is marked incomplete.
Result<Generation> generate(const Plan& plan, Designer& designer, const AssetLibrary& library,
                            const CategoryTable& categories, const GenerateOptions& options = {});

}  // namespace roomgen
