#include "prepare.h"

#include <algorithm>
#include <cmath>

#include "asset_task.h"
#include "library/asset_object.h"
#include "library/vocabulary.h"
#include "loads.h"
#include "retrieve.h"

namespace roomgen {

namespace {

// Assets that are looked at for one that can carry what it shall.
constexpr int most_carriers = 6;

bool is_able(Work& work, const PlannedObject& planned, const AssetInfo& asset,
             const std::vector<Load>& loads) {
  if (loads.empty()) return true;
  const auto task = prepare(work, planned, asset);
  return task && can_carry(task->object, loads, work.layout().support_poses());
}

// Metres from the floor to what it hangs from: the ceiling, or the underside of a thing.
double hook_of(const Work& work, const PlanItem& item) {
  for (const auto& relation : item.relations)
    if (relation.kind == RelationKind::hang_from)
      if (const Object* beam = work.layout().find(relation.target)) return bottom(*beam);
  return work.place.room.height;
}

// Of what hangs lower than it is high: its own height is `height`. NaN: it hangs right under the
// hook.
double hung_bottom(const PlanItem& item, double height, double hook) {
  const double said = item.bottom ? *item.bottom : item.height ? *item.height - 0.5 * height : hook;
  constexpr double shortest = 0.02;
  return item.mount == Mount::ceiling && said + height < hook - shortest ? std::max(0.0, said)
                                                                         : std::nan("");
}

}  // namespace

Result<PlacementTask> prepare(Work& work, const PlannedObject& planned, AssetInfo asset) {
  const PlanItem& item = work.item(planned);
  asset.ref.tilt = item.tilt;
  const Kind& category = work.category(planned);
  const Vec3 size = fitted_size(asset, category.size, item.size.value_or(category.size));
  const double hook = hook_of(work, item), hung = hung_bottom(item, size.z(), hook);
  if (!std::isnan(hung)) asset.ref.wires = rounded(1.0 - size.z() / (hook - hung));
  if (auto status = fetch_model(work.place, asset); !status) return status.error();
  const auto model = work.place.models.find(asset_key(asset.ref));
  auto task = task_of_asset(planned.id, item, category, asset, model.get(), work.place.room);
  if (!std::isnan(hung)) task.object.size.z() = hook - hung;
  if (item.mount == Mount::ceiling)
    task.object.position.z() = std::max(0.0, hook - task.object.size.z());
  return task;
}

Result<AssetInfo> asset_for(Work& work, const PlannedObject& planned) {
  const PlanItem& item = work.item(planned);
  const AssetInfo* known = favourite(work.state.favourites, item);
  const auto loads = loads_on(planned.id, work.place);
  if (known && (!item.asset.empty() || is_able(work, planned, *known, loads))) return *known;
  auto assets = assets_for(work, planned);
  if (!assets) return assets.error();
  if (assets->empty()) return Error{Error::Kind::not_found, why_no_asset(item)};
  return std::move(assets->front());
}

Result<std::vector<AssetInfo>> assets_for(Work& work, const PlannedObject& planned) {
  const Workplace& place = work.place;
  const auto loads = loads_on(planned.id, place);
  const auto few = static_cast<std::size_t>(place.options.assets_per_object);
  const int count = loads.empty() ? place.options.assets_per_object
                                  : std::max(place.options.assets_per_object, most_carriers);
  auto assets = retrieve({place.library, place.categories, place.options.seed},
                         work.state.favourites, work.item(planned), planned, count);
  if (!assets || loads.empty() || !work.item(planned).asset.empty()) return assets;
  const auto able = std::find_if(assets->begin(), assets->end(), [&](const AssetInfo& asset) {
    return is_able(work, planned, asset, loads);
  });
  if (able != assets->end()) std::rotate(assets->begin(), able, able + 1);
  if (assets->size() > few) assets->resize(few);
  return assets;
}

std::string why_no_asset(const PlanItem& item) {
  if (!item.asked || Vocabulary::built_in().understand(item.category).known)
    return "no asset is a " + item.category + " of this size";
  return "\"" + item.category + "\" is no kind that is known, and the words do not say of which parts " +
         "it is made";
}

}  // namespace roomgen
