#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <string>

namespace roomgen {

/// Points and directions. Metres, right-handed, Z up; Vec2 is a point of the floor seen from above,
/// x to the right, y up the page.
using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

inline constexpr double pi = std::numbers::pi;

inline double radians(double degrees) { return degrees * (pi / 180.0); }
inline double degrees(double radians) { return radians * (180.0 / pi); }

/// The z component of a x b: positive when b is to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A quarter turn to the left (counter-clockwise).
inline Vec2 left_of(const Vec2& v) { return {-v.y(), v.x()}; }

/// `v` turned counter-clockwise by `angle` radians.
inline Vec2 rotated(const Vec2& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

/// The same direction in (-pi, pi].
inline double wrap_angle(double angle) {
  const double wrapped = std::remainder(angle, 2.0 * pi);
  return wrapped <= -pi ? wrapped + 2.0 * pi : wrapped;
}

/// The front of an object looks to -Y at yaw 0.
inline Vec2 front_direction(double yaw) { return {std::sin(yaw), -std::cos(yaw)}; }

/// The yaw at which the front looks along `direction`.
inline double yaw_facing(const Vec2& direction) { return std::atan2(direction.x(), -direction.y()); }

/// "0.4 x 0.4 x 0.7", for people.
std::string size_text(const Vec3& size);

}  // namespace roomgen
