#include "asset_task.h"

#include "sizing.h"
#include "solve/layout.h"

namespace roomgen {

PlacementTask task_of_asset(const std::string& id, const PlanItem& item, const Kind& category,
                            const AssetInfo& asset, const Model* model, const Room& room) {
  PlacementTask task;
  Object& object = task.object;
  object.id = id;
  object.category = item.category;
  object.description = item.description.empty() ? asset.name : item.description;
  object.asset = asset.ref;
  object.stand_in = asset.stand_in;
  object.traits = category.traits;
  object.traits.front = category.traits.front && asset.has_front;
  object.size = fitted_size(asset, item, category);
  object.traits.round = asset.round && (!model || keeps_to_ellipse(*model, object.size));
  object.mount = item.mount;
  object.relations = item.relations;
  const double elevation = category.elevation > 0 ? category.elevation : asset.elevation;
  object.position.z() = mounting_height(item.mount, object.size.z(), elevation, room);
  task.location = item.location;
  task.asked = item.asked;
  return task;
}

}  // namespace roomgen
