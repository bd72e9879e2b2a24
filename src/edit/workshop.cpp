#include "workshop.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "solve/arrangement.h"

namespace roomgen {

namespace {

// All that a layout knows of an object.
bool stands_the_same(const Object& a, const Object& b) {
  return a.id == b.id && a.category == b.category && a.position == b.position && a.yaw == b.yaw && a.size == b.size &&
         a.on == b.on && a.mount == b.mount && a.traits == b.traits && a.asset == b.asset &&
         a.relations == b.relations && a.locked == b.locked;
}

}  // namespace

Workshop::FurnishedRoom::FurnishedRoom(const Room& the_room, const KindTable& kinds, const ModelTable& models)
    : room(the_room),
      layout(room, kinds, models, built_in_arrangements() ? &*built_in_arrangements() : nullptr) {}

void Workshop::fetch_models(const Scene& scene) {
  Scene lacking;
  lacking.room = scene.room;
  lacking.rooms = scene.rooms;
  const auto is_there = [&](const AssetRef& asset) {
    const std::string key = asset_key(asset);
    return key.empty() || missing_.count(key) > 0 || models_.find(key);
  };
  for (auto* rooms : {&lacking.rooms})
    for (auto& room : *rooms)
      std::erase_if(room.openings, [&](const Opening& opening) { return is_there(opening.joinery.asset); });
  std::erase_if(lacking.room.openings, [&](const Opening& opening) { return is_there(opening.joinery.asset); });
  for (const auto& object : scene.objects)
    if (!is_there(object.asset)) lacking.objects.push_back(object);
  const ModelTable found = load_models(lacking, library_, log_, spare_);
  const auto keep = [&](const AssetRef& asset) {
    const std::string key = asset_key(asset);
    if (auto model = found.find(key)) models_.add(key, std::move(model));
    else missing_.insert(key);
  };
  for (const auto& room : rooms_of(lacking))
    for (const auto& opening : room.openings) keep(opening.joinery.asset);
  for (const auto& object : lacking.objects) keep(object.asset);
}

Result<std::shared_ptr<const Model>> Workshop::fetch_model(const AssetRef& asset) {
  const std::string key = asset_key(asset);
  if (key.empty()) return std::shared_ptr<const Model>();
  if (auto known = models_.find(key)) return known;
  auto model = load_model(library_, asset);
  if (model) models_.add(key, *model);
  return model;
}

std::optional<Vec3> Workshop::mesh_size(const AssetRef& asset) {
  const auto model = models_.find(asset_key(asset));
  if (!model) return std::nullopt;
  const auto known = mesh_sizes_.find(model.get());
  return known != mesh_sizes_.end() ? known->second : mesh_sizes_[model.get()] = bounds(*model).size();
}

Layout& Workshop::layout(const Scene& scene, const std::string& room_id, const std::set<std::string>& without) {
  auto& place = rooms_[room_id];
  const auto rooms = rooms_of(scene);
  const auto room = std::find_if(rooms.begin(), rooms.end(), [&](const Room& one) { return one.id == room_id; });
  if (!place || to_json(place->room) != to_json(*room))
    place = std::make_unique<FurnishedRoom>(*room, kinds_, models_);
  std::vector<const Object*> wanted;
  for (const auto& object : scene.objects)
    if (object.room == room_id && !without.count(object.id)) wanted.push_back(&object);
  Layout& layout = place->layout;
  std::size_t same = 0;
  while (same < wanted.size() && same < layout.objects().size() &&
         stands_the_same(layout.objects()[same], *wanted[same]))
    ++same;
  while (layout.objects().size() > same) {
    const std::string last = layout.objects().back().id;
    layout.remove(last);
  }
  for (; same < wanted.size(); ++same) layout.add(*wanted[same]);
  return layout;
}

}  // namespace roomgen
