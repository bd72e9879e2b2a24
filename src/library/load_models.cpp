#include "roomgen/library/library.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace roomgen {

namespace {

std::size_t bytes_of(const Mesh& mesh) {
  return mesh.positions.size() * sizeof mesh.positions[0] + mesh.normals.size() * sizeof mesh.normals[0] +
         mesh.uvs.size() * sizeof mesh.uvs[0] + mesh.triangles.size() * sizeof mesh.triangles[0];
}

void lean(Model& model, const Vec2& tilt) {
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(tilt.y(), Vec3::UnitY()) *
                                Eigen::AngleAxisd(tilt.x(), Vec3::UnitX()))
                                   .toRotationMatrix();
  for (auto& part : model.parts) {
    for (auto& position : part.mesh.positions) position = turn.cast<float>() * position;
    for (auto& normal : part.mesh.normals) normal = turn.cast<float>() * normal;
  }
  const Bounds3 box = bounds(model);
  const Vec3 foot(box.center().x(), box.center().y(), box.low.z());
  for (auto& part : model.parts)
    for (auto& position : part.mesh.positions) position -= foot.cast<float>();
}

// The highest point of what is near a place, seen from above; without any the middle.
double top_at(const Model& model, const Bounds3& box, const Vec2& at) {
  const double near = 0.06 * box.size().head<2>().norm();
  double top = -1.0;
  for (const auto& part : model.parts)
    for (const auto& position : part.mesh.positions)
      if ((position.head<2>().cast<double>() - at).norm() < near)
        top = std::max(top, static_cast<double>(position.z()));
  return top < 0.0 ? box.center().z() : top;
}

// Straight up from the thing: one in its middle, two of what is long.
void hang_by_wires(Model& model, double share) {
  constexpr double long_from = 1.8, apart = 0.35, thin = 0.003;
  const Bounds3 box = bounds(model);
  const Vec3 size = box.size();
  const double end = box.low.z() + size.z() / (1.0 - share), half = thin * size.maxCoeff();
  const int axis = size.x() >= size.y() ? 0 : 1;
  const Vec2 aside = apart * size[axis] * Vec2::Unit(axis);
  std::vector<Vec2> feet = {box.center().head<2>()};
  if (size[axis] > long_from * size[1 - axis]) feet = {feet[0] - aside, feet[0] + aside};
  ModelPart wires{{}, static_cast<int>(model.materials.size())};
  for (const Vec2& at : feet)
    append(wires.mesh, make_box({at.x() - half, at.y() - half, top_at(model, box, at)},
                                {at.x() + half, at.y() + half, end}));
  model.materials.push_back({"wire", {0.15f, 0.15f, 0.15f, 1.0f}, nullptr});
  model.parts.push_back(std::move(wires));
}

/// Fills a table with the models of a scene, until it is full.
class Loading {
 public:
  Loading(const AssetLibrary& library, const LogSink& log_sink, const SpareModels& spare, const ModelLimits& limits)
      : library_(library), log_sink_(log_sink), spare_(spare), limits_(limits) {}

  void add(const std::string& owner, const AssetRef& asset) {
    const std::string key = asset_key(asset);
    if (key.empty() || models_.find(key)) return;
    if (count_ >= limits_.models || bytes_ >= limits_.bytes) return tell_full(owner);
    ++count_;  // whether or not it can be read: failing takes time as well
    auto model = load_model(library_, asset);
    if (model) return keep(key, *std::move(model));
    if (auto other = spare_ ? spare_(key) : nullptr) return keep(key, std::move(other));
    log(log_sink_, LogLevel::warning, owner + ": " + model.error().message);
  }

  ModelTable table() && { return std::move(models_); }

 private:
  void keep(const std::string& key, std::shared_ptr<const Model> model) {
    for (const auto& part : model->parts) bytes_ += bytes_of(part.mesh);
    for (const auto& material : model->materials)
      if (material.texture && textures_.insert(material.texture.get()).second) bytes_ += material.texture->pixels.size();
    models_.add(key, std::move(model));
  }

  void tell_full(const std::string& owner) {
    if (!std::exchange(is_full_, true))
      log(log_sink_, LogLevel::warning,
          owner + " and what comes after it with another model: a scene may have " + std::to_string(limits_.models) +
              " of them, of " + std::to_string(limits_.bytes >> 20) + " MB in all");
  }

  const AssetLibrary& library_;
  const LogSink& log_sink_;
  const SpareModels& spare_;
  const ModelLimits& limits_;
  ModelTable models_;
  std::size_t count_ = 0, bytes_ = 0;
  std::set<const Image*> textures_;  ///< models share them
  bool is_full_ = false;
};

}  // namespace

Result<std::shared_ptr<const Model>> load_model(const AssetLibrary& library, const AssetRef& ref) {
  AssetRef alone = ref;
  alone.tilt.setZero(), alone.wires = 0.0;
  auto loaded = library.load(alone);
  if (!loaded || (ref.tilt.isZero() && ref.wires <= 0.0)) return loaded;
  Model model = **loaded;
  if (!ref.tilt.isZero()) lean(model, ref.tilt);
  if (ref.wires > 0.0) hang_by_wires(model, ref.wires);
  return std::make_shared<const Model>(std::move(model));
}

ModelTable load_models(const Scene& scene, const AssetLibrary& library, const LogSink& log_sink,
                       const SpareModels& spare, const ModelLimits& limits) {
  Loading loading(library, log_sink, spare, limits);
  for (const auto& room : rooms_of(scene))
    for (const auto& opening : room.openings) loading.add(opening.id, opening.joinery.asset);
  for (const auto& object : scene.objects) loading.add(object.id, object.asset);
  return std::move(loading).table();
}

}  // namespace roomgen
