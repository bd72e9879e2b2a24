#include "model_camera.h"

#include <Eigen/Geometry>
#include <cmath>

namespace roomgen {

namespace {

constexpr double margin = 0.06;      // of the picture, on each side
constexpr double depth_slack = 0.5;  // metres

}  // namespace

const std::vector<ModelView>& model_views() {
  static const std::vector<ModelView> views = {{"front", 0.0, 0.0},
                                               {"side", 0.5 * pi, 0.0},
                                               {"back", pi, 0.0},
                                               {"above", radians(35.0), radians(30.0)}};
  return views;
}

Camera model_camera(const Bounds3& box, const ModelView& view, int pixels) {
  const Vec2 to_viewer = front_direction(view.yaw);
  Camera camera;
  camera.width = camera.height = pixels;
  camera.backward << std::cos(view.elevation) * to_viewer, std::sin(view.elevation);
  camera.right << left_of(to_viewer), 0.0;
  camera.up = camera.backward.cross(camera.right);
  const Vec3 center = box.center();
  camera.center = {camera.right.dot(center), camera.up.dot(center)};
  const double reach = std::max(0.5 * box.size().norm(), 1e-4);
  // The diagonal would fit whatever the view; furniture seen level needs less.
  const Vec3 size = box.size();
  const double width = size.head<2>().norm(), height = 0.5 * width + 0.87 * size.z();
  const double wanted = std::max({width, height, size.z(), 1e-3});
  camera.pixels_per_metre = pixels * (1.0 - 2.0 * margin) / wanted;
  camera.near = camera.depth(center) + 3.0 * reach + depth_slack;
  camera.far = camera.depth(center) - 3.0 * reach - depth_slack;
  return camera;
}

}  // namespace roomgen
