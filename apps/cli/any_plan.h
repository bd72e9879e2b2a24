#pragma once

#include <string>
#include <variant>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/design/designer.h"
#include "roomgen/generate/generate.h"
#include "roomgen/scene/plan.h"

namespace roomgen::cli {

/// What is to be furnished: one room, or the rooms of a dwelling.
using AnyPlan = std::variant<Plan, DwellingPlan>;

/// What a person says of a plan.
struct PlanWish {
  std::string prompt;
  std::uint64_t seed = 0;
  std::string size;        ///< "4x5"; empty: as the prompt or the rules say
  std::string floor_plan;  ///< a file: room.json, SVG or DXF
  std::vector<std::string> pictures = {};  ///< PlanRequest::pictures
};

/// What a designer is asked.
Result<PlanRequest> request_of(const PlanWish& wish, const CancelToken& cancel);
/// `reader`: null for rules.
Result<AnyPlan> make_plan(const PlanWish& wish, Designer& designer, const CancelToken& cancel,
                          Reader* reader = nullptr);
/// An error of planning a wish by rules, or of furnishing its plan, as with_least_size() tells it;
/// of dwellings as it is.
Error told_with_least_size(const Error& error, const PlanWish& wish, const AnyPlan* plan,
                           const AssetLibrary& library, const BuildOptions& options);
/// plan.json of a room or of a dwelling.
Result<AnyPlan> read_any_plan(const std::string& file);

Json plan_json(const AnyPlan& plan);
/// The same with what the designer chose for its things.
Json plan_json(AnyPlan plan, const Generation& generation);
/// What was assumed; of a dwelling that of its rooms too.
std::vector<std::string> notes_of(const AnyPlan& plan);

}  // namespace roomgen::cli
