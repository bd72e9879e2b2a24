#include "draw_list.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace roomgen::detail {

namespace {

constexpr std::size_t cache_budget = 192u << 20;

Bounds3 placed_bounds(const Bounds3& box, const Eigen::Matrix4d& room_from_model) {
  Bounds3 placed;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector4d p(corner & 1 ? box.high.x() : box.low.x(),
                            corner & 2 ? box.high.y() : box.low.y(),
                            corner & 4 ? box.high.z() : box.low.z(), 1.0);
    placed.add((room_from_model * p).head<3>());
  }
  return placed;
}

}  // namespace

bool DrawItem::same_as(const DrawItem& other) const {
  return source == other.source && placement.scale == other.placement.scale &&
         placement.yaw == other.placement.yaw && placement.position == other.placement.position;
}

Eigen::Matrix4d DrawItem::room_from_model() const {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  const Eigen::Matrix3d turn(Eigen::AngleAxisd(placement.yaw, Vec3::UnitZ()));
  m.topLeftCorner<3, 3>() = turn * placement.scale.asDiagonal();
  m.topRightCorner<3, 1>() = placement.position;
  return m;
}

Eigen::Matrix3d DrawItem::room_from_normal() const {
  const Eigen::Matrix3d turn(Eigen::AngleAxisd(placement.yaw, Vec3::UnitZ()));
  return turn * placement.scale.cwiseInverse().asDiagonal();
}

std::shared_ptr<const GpuModel> GpuCache::get(const std::string& key,
                                              const std::shared_ptr<const Model>& source) {
  Entry& entry = entries_[key];
  if (entry.source != source) {
    entry.source = source;
    entry.model = std::make_shared<GpuModel>(*gl_, *source);
  }
  entry.last_used = pictures_;
  return entry.model;
}

std::shared_ptr<const Model> GpuCache::source(const std::string& key) const {
  const auto found = entries_.find(key);
  return found == entries_.end() ? nullptr : found->second.source;
}

void GpuCache::drop_unused() {
  std::size_t total = 0;
  for (const auto& [key, entry] : entries_) total += entry.model->bytes();
  while (total > cache_budget) {
    const auto oldest = std::min_element(
        entries_.begin(), entries_.end(),
        [](const auto& a, const auto& b) { return a.second.last_used < b.second.last_used; });
    if (oldest->second.last_used == pictures_) break;
    total -= oldest->second.model->bytes();
    entries_.erase(oldest);
  }
  ++pictures_;
}

DrawItem fixed_item(const std::string& key, const std::shared_ptr<const Model>& model, GpuCache& cache) {
  DrawItem item;
  item.source = model;
  item.model = cache.get(key, model);
  item.box = item.model->model_bounds();
  return item;
}

DrawItem draw_object(const Object& object, const ModelTable& models, GpuCache& cache) {
  const std::string key = model_key(object, models);
  DrawItem item;
  item.source = models.find(asset_key(object.asset));
  // A box is made once and then known by its key.
  if (!item.source) item.source = cache.source(key);
  if (!item.source) item.source = std::make_shared<Model>(box_model(object));
  item.model = cache.get(key, item.source);
  item.placement = model_placement(object, item.model->model_bounds());
  item.box = placed_bounds(item.model->model_bounds(), item.room_from_model());
  return item;
}

DrawList draw_objects(const Scene& scene, const ModelTable& models,
                      const std::function<bool(const Object&)>& shown, GpuCache& cache) {
  DrawList list;
  for (const auto& object : scene.objects)
    if (shown(object)) list.push_back(draw_object(object, models, cache));
  return list;
}

}  // namespace roomgen::detail
