#pragma once

#include <string>

#include "roomgen/library/library.h"
#include "roomgen/scene/plan.h"
#include "roomgen/scene/problem.h"

namespace roomgen {

/// The object that an asset makes of an item: at its size and mounting height, with the item's relations,
/// location and whether it was asked for. `model` is the asset's mesh; may be null.
PlacementTask task_of_asset(const std::string& id, const PlanItem& item, const Kind& category,
                            const AssetInfo& asset, const Model* model, const Room& room);

}  // namespace roomgen
