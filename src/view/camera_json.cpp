#include "camera_json.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

namespace roomgen {

namespace {

Json matrix_json(const Eigen::Matrix4d& m) {
  Json rows = Json::array();
  for (int row = 0; row < 4; ++row) {
    Json values = Json::array();
    for (int column = 0; column < 4; ++column) values.push_back(rounded(m(row, column), 9));
    rows.push_back(values);
  }
  return rows;
}

// To axes as OpenCV has them: x to the right, y down, z away from the viewer.
Eigen::Matrix4d world_from_camera(const Camera& camera) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() << camera.right, -camera.up, -camera.backward;
  m.topRightCorner<3, 1>() = camera.origin();
  return m;
}

}  // namespace

Json camera_json(const Camera& camera) {
  const double scale = camera.pixels_per_metre;
  // With parallel rays the origin is before the picture's middle already.
  const Vec2 shift = camera.eye ? Vec2(scale * camera.center) : Vec2(Vec2::Zero());
  const Eigen::Matrix4d pose = world_from_camera(camera);
  return {{"model", camera.eye ? "pinhole" : "orthographic"},
          {"width", camera.width},
          {"height", camera.height},
          {camera.eye ? "focal_length_px" : "pixels_per_metre", {rounded(scale, 6), rounded(scale, 6)}},
          {"principal_point_px",
           {rounded(0.5 * camera.width - shift.x(), 6), rounded(0.5 * camera.height + shift.y(), 6)}},
          {"axes", "x right, y down, z forward"},
          {"world_from_camera", matrix_json(pose)},
          {"camera_from_world", matrix_json(pose.inverse())}};
}

}  // namespace roomgen
