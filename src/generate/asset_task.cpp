#include "asset_task.h"

#include <algorithm>
#include <cmath>

#include "library/asset_object.h"
#include "sizing.h"
#include "solve/layout.h"

namespace roomgen {

PlacementTask task_of_asset(const std::string& id, const PlanItem& item, const Kind& category,
                            const AssetInfo& asset, const Model* model, const Room& room) {
  PlacementTask task;
  Object& object = task.object;
  const Vec3 size = fitted_size(asset, category.size, item.size.value_or(category.size));
  object = object_of_asset(asset, category, size, model);
  if (model && !asset.ref.tilt.isZero()) {
    object.size = bounds(*model).size() * std::cbrt(size.cwiseQuotient(asset.size).prod());
    object.traits.round = false;
  }
  object.id = id;
  object.category = item.category;
  object.description = item.description.empty() ? asset.name : item.description;
  object.mount = item.mount;
  object.relations = item.relations;
  double elevation = category.elevation > 0 ? category.elevation : asset.elevation;
  if (item.height) elevation = std::max(0.0, *item.height - 0.5 * object.size.z());
  elevation = item.bottom.value_or(elevation);
  object.position.z() = mounting_height(item.mount, object.size.z(), elevation, room);
  task.location = item.location;
  task.asked = item.asked;
  return task;
}

}  // namespace roomgen
