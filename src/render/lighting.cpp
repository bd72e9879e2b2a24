#include "lighting.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace roomgen::detail {

namespace {

// Rows map room points to [-1, 1] along each axis.
Eigen::Matrix4d box_projection(const std::array<Vec3, 3>& axes, const Vec3& center,
                               const Vec3& half) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  for (int row = 0; row < 3; ++row) {
    m.block<1, 3>(row, 0) = axes[static_cast<std::size_t>(row)].transpose() / half[row];
    m(row, 3) = -center[row] / half[row];
  }
  return m;
}

// Rays that meet in the eye: everything is divided by its distance before it.
Eigen::Matrix4d clip_from_seen_room(const Camera& camera) {
  const auto [near, far] = planes(camera);
  const double x = 2.0 * camera.pixels_per_metre / camera.width;
  const double y = 2.0 * camera.pixels_per_metre / camera.height;
  Eigen::Matrix<double, 4, 3> turn;
  turn.row(0) = x * (camera.right + camera.center.x() * camera.backward).transpose();
  turn.row(1) = -y * (camera.up + camera.center.y() * camera.backward).transpose();
  turn.row(2) = -(far + near) / (far - near) * camera.backward.transpose();
  turn.row(3) = -camera.backward.transpose();
  Eigen::Matrix4d m;
  m.leftCols<3>() = turn;
  m.col(3) = -turn * *camera.eye;
  m(2, 3) -= 2.0 * far * near / (far - near);
  return m;
}

}  // namespace

Vec3 sun_direction(const Camera& camera, View::Kind kind) {
  if (kind == View::Kind::top)
    return (-0.34 * camera.right + 0.40 * camera.up + camera.backward).normalized();
  const Vec3 to_viewer = Vec3(camera.backward.x(), camera.backward.y(), 0).normalized();
  return (-0.40 * camera.right + 0.62 * to_viewer + 1.10 * Vec3::UnitZ()).normalized();
}

Sun make_sun(const Vec3& direction, const std::vector<Vec3>& points) {
  const Vec3 side = std::abs(direction.z()) < 0.99 ? Vec3::UnitZ() : Vec3::UnitX();
  const Vec3 right = side.cross(direction).normalized();
  const Vec3 up = direction.cross(right);
  Bounds3 box;
  for (const auto& p : points) box.add({right.dot(p), up.dot(p), -direction.dot(p)});
  Vec3 half = 0.5 * box.size() + Vec3::Constant(0.05);
  half.x() = half.y() = std::max(half.x(), half.y());
  return {direction, box_projection({right, up, -direction}, box.center(), half), 2.0 * half.x(),
          2.0 * half.z()};
}

Planes planes(const Camera& camera) {
  const double at = camera.depth(*camera.eye);
  return {at - camera.near, at - camera.far};
}

Eigen::Matrix4d clip_from_room(const Camera& camera) {
  if (camera.eye) return clip_from_seen_room(camera);
  const Vec3 center(camera.center.x(), -camera.center.y(), -0.5 * (camera.near + camera.far));
  const Vec3 half(0.5 * camera.width / camera.pixels_per_metre,
                  0.5 * camera.height / camera.pixels_per_metre, 0.5 * (camera.near - camera.far));
  return box_projection({camera.right, -camera.up, -camera.backward}, center, half);
}

}  // namespace roomgen::detail
