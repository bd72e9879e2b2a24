#pragma once

#include "workplace.h"

namespace roomgen {

/// The object as an asset makes it, at its size and mounting height; its mesh is fetched. Its relations are
/// those of the plan.
Result<PlacementTask> prepare(Work& work, const PlannedObject& planned, AssetInfo asset);

/// The assets to try for an object, the best first. What shall carry things takes one that can, if there
/// is one. Empty if nothing fits.
Result<std::vector<AssetInfo>> assets_for(Work& work, const PlannedObject& planned);

/// The first of them: what others of the same words took is not looked for again.
Result<AssetInfo> asset_for(Work& work, const PlannedObject& planned);

/// Why there are none.
std::string why_no_asset(const PlanItem& item);

}  // namespace roomgen
