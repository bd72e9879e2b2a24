#include <algorithm>

#include "builder_steps.h"
#include "retrieve.h"
#include "window_cover.h"

namespace roomgen {

namespace {

// What is made to the measure of a window may be stretched a little.
constexpr double least_to_measure = 0.75, most_to_measure = 1.3;

Error no_place(const std::string& why) { return {Error::Kind::not_found, why}; }

std::vector<const Opening*> windows_in_order(const Room& room, std::span<const Object> objects,
                                             const PlanItem& item) {
  auto windows = windows_to_cover(room, objects, item.category);
  for (const auto& relation : item.relations)
    std::stable_partition(windows.begin(), windows.end(),
                          [&](const Opening* window) { return window->id == relation.target; });
  return windows;
}

Object unhung_cover(const std::string& id, const PlanItem& item, const Kind& category) {
  Object object;
  object.id = id;
  object.category = item.category;
  object.mount = Mount::wall;
  object.traits = category.traits;
  object.size = category.size;
  return object;
}

std::optional<double> said_height(const PlanItem& item) {
  return item.size ? std::optional(item.size->z()) : std::nullopt;
}

// An asset for the box, or nothing if none is of this size.
Result<std::optional<AssetInfo>> made_to_measure(const Work& work, const PlannedObject& planned,
                                                 const Object& hung) {
  const Workplace& place = work.place;
  PlanItem item = work.item(planned);
  item.size = hung.size;
  item.asked = true;
  const auto assets = retrieve({place.library, place.categories, place.options.seed},
                               work.state.favourites, item, planned,
                               place.options.assets_per_object);
  if (!assets) return assets.error();
  for (const auto& asset : *assets) {
    const Vec3 stretch = hung.size.cwiseQuotient(asset.size);
    if (stretch.minCoeff() >= least_to_measure && stretch.maxCoeff() <= most_to_measure)
      return std::optional(asset);
  }
  return std::optional<AssetInfo>();
}

// Makes the object of the asset, and says whether there is room for it.
bool may_hang(Work& work, const PlannedObject& planned, const AssetInfo& asset, Object& hung) {
  if (!fetch_model(work.place, asset)) return false;
  const PlanItem& item = work.item(planned);
  hung.description = item.description.empty() ? asset.name : item.description;
  hung.asset = asset.ref;
  hung.locked = true;  // its window stays where it is
  hung.traits.front = hung.traits.front && asset.has_front;
  const auto candidate = work.layout().candidate(hung);
  return work.layout().fits(candidate, footprint(hung), bottom(hung)) &&
         work.layout().fits_exactly(candidate);
}

}  // namespace

Result<Hanging> find_hanging(Work& work, const PlannedObject& planned) {
  const Kind& category = work.category(planned);
  const Object object = unhung_cover(planned.id, work.item(planned), category);
  const auto windows = windows_in_order(work.place.room, work.layout().objects(), work.item(planned));
  if (windows.empty()) return no_place("the room has no window at which it could hang");
  for (const Opening* window : windows)
    for (auto& hung :
         hangings(object, category, work.place.room, *window, said_height(work.item(planned)))) {
      const auto asset = made_to_measure(work, planned, hung);
      if (!asset) return asset.error();
      if (*asset && may_hang(work, planned, **asset, hung))
        return Hanging{std::move(hung), **asset, window->id};
    }
  return no_place("at no window is there room for it");
}

void measure_covers(Workplace& place) {
  for (auto& item : place.plan.items) {
    const Kind& kind = place.categories.get(item.category);
    if (!kind.covers_window) continue;
    const auto windows = windows_in_order(place.room, {}, item);
    if (windows.empty()) continue;
    const auto hung = hangings(unhung_cover("", item, kind), kind, place.room, *windows.front(),
                               said_height(item));
    if (!hung.empty()) item.size = hung.front().size;
  }
}

void hang_up(Work& work, const PlannedObject& planned, Hanging hanging) {
  work.layout().add(std::move(hanging.object));
  remember(work.state.favourites, work.item(planned), hanging.asset);
  work.state.assets[planned.id] = std::move(hanging.asset);
}

}  // namespace roomgen
