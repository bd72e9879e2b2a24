#include "oriented_box.h"

#include <cmath>

namespace roomgen::lab {

namespace {

constexpr double epsilon = 1e-6;

}  // namespace

Vec3 OrientedBox::to_local(const Vec3& point) const {
  const Vec3 offset = point - center;
  const Vec2 flat = rotated(offset.head<2>(), -yaw);
  return {flat.x(), flat.y(), offset.z()};
}

Vec3 OrientedBox::to_world(const Vec3& local) const {
  const Vec2 flat = rotated(local.head<2>(), yaw);
  return center + Vec3(flat.x(), flat.y(), local.z());
}

Vec3 OrientedBox::front() const {
  const Vec2 flat = front_direction(yaw);
  return {flat.x(), flat.y(), 0.0};
}

double OrientedBox::volume() const { return (2.0 * half).cwiseMax(epsilon).prod(); }

double OrientedBox::half_extent(const Vec2& direction) const {
  return half.head<2>().dot(rotated(direction, -yaw).cwiseAbs());
}

bool OrientedBox::contains(const Vec3& point) const {
  return (to_local(point).cwiseAbs().array() <= half.array() + epsilon).all();
}

bool OrientedBox::at_side(const Vec3& point, BoxSide side, bool outside, double margin) const {
  const Vec3 p = to_local(point);
  const int axis = side == BoxSide::left || side == BoxSide::right   ? 0
                   : side == BoxSide::front || side == BoxSide::back ? 1
                                                                     : 2;
  const bool positive = side == BoxSide::right || side == BoxSide::back || side == BoxSide::top;
  const double beyond = outside ? half[axis] : 0.0;
  if ((positive ? p[axis] : -p[axis]) < beyond - epsilon) return false;
  for (int other = 0; other < 3; ++other)
    if (other != axis && std::abs(p[other]) > half[other] * (1.0 + margin)) return false;
  return true;
}

std::vector<Vec3> OrientedBox::points(int n) const {
  std::vector<Vec3> result;
  result.reserve(static_cast<std::size_t>(n) * n * n);
  const auto middle = [n](int i) { return (2.0 * i + 1.0) / n - 1.0; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        result.push_back(to_world(Vec3(middle(i), middle(j), middle(k)).cwiseProduct(half)));
  return result;
}

OrientedBox box_of(const Object& object) {
  const Vec3 half = 0.5 * object.size;
  return {object.position + Vec3(0, 0, half.z()), half, object.yaw};
}

}  // namespace roomgen::lab
