#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "gpu_model.h"
#include "roomgen/scene/scene.h"
#include "scene/box_model.h"

namespace roomgen::detail {

/// One model at its place.
struct DrawItem {
  std::shared_ptr<const Model> source;  ///< keeps its address, by which equal items are known
  std::shared_ptr<const GpuModel> model;
  ModelPlacement placement;
  Bounds3 box;  ///< in the room

  bool same_as(const DrawItem& other) const;
  Eigen::Matrix4d room_from_model() const;
  /// Turns normals: the inverse transpose of the linear part, up to a factor.
  Eigen::Matrix3d room_from_normal() const;
};

using DrawList = std::vector<DrawItem>;

/// Models in the renderer's memory by key. Those that the latest scenes did not use go when there
/// are too many.
class GpuCache {
 public:
  explicit GpuCache(const Gl& gl) : gl_(&gl) {}

  /// The model of this key; uploaded again if the key now means another model.
  std::shared_ptr<const GpuModel> get(const std::string& key,
                                      const std::shared_ptr<const Model>& source);
  /// The model last uploaded under this key, or null.
  std::shared_ptr<const Model> source(const std::string& key) const;
  /// To be called once a picture.
  void drop_unused();

 private:
  struct Entry {
    std::shared_ptr<const Model> source;
    std::shared_ptr<const GpuModel> model;
    long long last_used = 0;
  };
  const Gl* gl_;
  std::map<std::string, Entry> entries_;
  long long pictures_ = 0;
};

/// What is in room coordinates already.
DrawItem fixed_item(const std::string& key, const std::shared_ptr<const Model>& model, GpuCache& cache);
DrawItem draw_object(const Object& object, const ModelTable& models, GpuCache& cache);
/// The objects of a scene that are to be `shown`, in their order.
DrawList draw_objects(const Scene& scene, const ModelTable& models,
                      const std::function<bool(const Object&)>& shown, GpuCache& cache);

}  // namespace roomgen::detail
