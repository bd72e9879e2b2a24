#include "roomgen/geometry/polygon.h"

#include <algorithm>
#include <limits>

#include "inside.h"

namespace roomgen {

namespace {

constexpr double touching = 1e-9;  // metres

// Interval of the outline's projections on an axis.
std::pair<double, double> project(const Footprint& footprint, const Vec2& axis) {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  for (const auto& corner : footprint.outline()) {
    const double value = corner.dot(axis);
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return {low, high};
}

// One half of the separating axis test: is an edge of `a` a separating line?
bool separated_by_edge_of(const Footprint& a, const Footprint& b, double tolerance) {
  const auto outline = a.outline();
  // Opposite edges of a rectangle are parallel: two axes are enough.
  const std::size_t axes = a.round() ? outline.size() : 2;
  for (std::size_t i = 0; i < axes; ++i) {
    const Vec2 edge = outline[(i + 1) % outline.size()] - outline[i];
    const Vec2 outward = -left_of(edge).normalized();
    const auto [low_b, high_b] = project(b, outward);
    const auto [low_a, high_a] = project(a, outward);
    if (low_b > high_a - tolerance || low_a > high_b - tolerance) return true;
  }
  return false;
}

// The separating axis test for two rectangles: on the axes of each, half extents against distance.
bool rectangles_overlap(const Footprint& a, const Footprint& b, double tolerance) {
  const Vec2 between = b.center() - a.center();
  const double c = std::abs(a.x_axis().dot(b.x_axis())), s = std::abs(a.x_axis().dot(b.y_axis()));
  const Vec2 &p = a.half(), &q = b.half();
  return std::abs(between.dot(a.x_axis())) < p.x() + c * q.x() + s * q.y() - tolerance &&
         std::abs(between.dot(a.y_axis())) < p.y() + s * q.x() + c * q.y() - tolerance &&
         std::abs(between.dot(b.x_axis())) < q.x() + c * p.x() + s * p.y() - tolerance &&
         std::abs(between.dot(b.y_axis())) < q.y() + s * p.x() + c * p.y() - tolerance;
}

// Most things stand square to the walls and to each other: then distances are those of boxes.
constexpr double parallel = 1e-9;

bool are_square(const Vec2& axis, const Vec2& other) {
  return std::abs(axis.dot(other)) < parallel || std::abs(cross(axis, other)) < parallel;
}

double box_distance(const Vec2& point, const Vec2& half) {
  return (point.cwiseAbs() - half).cwiseMax(0.0).norm();
}

// Liang-Barsky clipping of the segment against a box around the origin.
bool clips(const Vec2& a, const Vec2& b, const Vec2& half) {
  double enter = 0.0, leave = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double start = a[axis], delta = b[axis] - a[axis];
    if (std::abs(delta) < 1e-15) {
      if (std::abs(start) >= half[axis]) return false;
      continue;
    }
    const double t0 = (-half[axis] - start) / delta, t1 = (half[axis] - start) / delta;
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  return enter < leave;
}

// No more than the distance of what is in the box.
double box_distance(const Bounds2& box, const Vec2& point) {
  return (box.low - point).cwiseMax(point - box.high).cwiseMax(0.0).norm();
}

}  // namespace

bool passes_through(const Footprint& footprint, const Segment& segment, double margin) {
  // Of a room's many walls most are far from any thing.
  if (margin >= 0.0 && is_beyond(footprint.bounds(), segment.a, segment.b, touching)) return false;
  const Vec2 half = (footprint.half().array() - margin).max(1e-9).matrix();
  const Vec2 a = footprint.to_local(segment.a), b = footprint.to_local(segment.b);
  if (!footprint.round()) return clips(a, b, half);
  // Scaled so that the ellipse becomes the unit circle.
  return distance({a.cwiseQuotient(half), b.cwiseQuotient(half)}, Vec2::Zero()) < 1.0;
}

Footprint::Footprint(const Vec2& center, const Vec2& size, double yaw, bool round)
    : center_(center), half_(0.5 * size), yaw_(yaw), cos_(std::cos(yaw)), sin_(std::sin(yaw)) {
  if (round) {
    count_ = round_sides;
    // Edges touch the ellipse at their middles, four of them on the axes.
    const double stretch = 1.0 / std::cos(pi / round_sides);
    for (std::size_t i = 0; i < round_sides; ++i) {
      const double angle = 2.0 * pi * (static_cast<double>(i) + 0.5) / round_sides;
      corners_[i] =
          to_world({stretch * half_.x() * std::cos(angle), stretch * half_.y() * std::sin(angle)});
    }
  } else {
    const Vec2 x = half_.x() * x_axis(), y = half_.y() * y_axis();
    corners_[0] = center_ + x + y;
    corners_[1] = center_ - x + y;
    corners_[2] = center_ - x - y;
    corners_[3] = center_ + x - y;
  }
  for (const auto& corner : outline()) bounds_.add(corner);
}

Footprint Footprint::moved_to(const Vec2& center) const {
  Footprint moved = *this;
  const Vec2 shift = center - center_;
  moved.center_ = center;
  for (std::size_t i = 0; i < count_; ++i) moved.corners_[i] += shift;
  moved.bounds_.low += shift;
  moved.bounds_.high += shift;
  return moved;
}

Vec2 Footprint::to_local(const Vec2& point) const {
  const Vec2 d = point - center_;
  return {cos_ * d.x() + sin_ * d.y(), -sin_ * d.x() + cos_ * d.y()};
}

Vec2 Footprint::to_world(const Vec2& local) const {
  return {center_.x() + cos_ * local.x() - sin_ * local.y(),
          center_.y() + sin_ * local.x() + cos_ * local.y()};
}

double Footprint::area() const {
  return (round() ? pi : 4.0) * half_.x() * half_.y();
}

bool overlaps(const Footprint& a, const Footprint& b, double tolerance) {
  if (!a.bounds().overlaps(b.bounds(), -tolerance)) return false;
  if (!a.round() && !b.round()) return rectangles_overlap(a, b, tolerance);
  return !separated_by_edge_of(a, b, tolerance) && !separated_by_edge_of(b, a, tolerance);
}

double gap(const Footprint& a, const Footprint& b) {
  if (!a.round() && !b.round() && are_square(a.x_axis(), b.x_axis())) {
    const bool quarter = std::abs(a.x_axis().dot(b.x_axis())) < 0.5;
    const Vec2 other = quarter ? Vec2(b.half().y(), b.half().x()) : b.half();
    return box_distance(a.to_local(b.center()), a.half() + other);
  }
  if (overlaps(a, b, 0.0)) return 0.0;
  // Convex and apart: the nearest points are a corner of one and some point of the other.
  double best = std::numeric_limits<double>::max();
  const auto come_closer = [&best](const Footprint& from, const Footprint& to) {
    for (const auto& corner : from.outline())
      if (box_distance(to.bounds(), corner) < best) best = std::min(best, gap(to, corner));
  };
  come_closer(a, b), come_closer(b, a);
  return best;
}

double gap(const Footprint& footprint, const Segment& segment) {
  if (!footprint.round()) {
    const Vec2 a = footprint.to_local(segment.a), b = footprint.to_local(segment.b);
    if ((a - b).cwiseAbs().minCoeff() < parallel)
      return box_distance(0.5 * (a + b), footprint.half() + 0.5 * (a - b).cwiseAbs());
  }
  if (contains(footprint, segment.a) || contains(footprint, segment.b)) return 0.0;
  if (!footprint.round() && passes_through(footprint, segment)) return 0.0;
  const auto outline = footprint.outline();
  double best = std::min(gap(footprint, segment.a), gap(footprint, segment.b));
  for (const auto& corner : outline) best = std::min(best, distance(segment, corner));
  if (footprint.round())
    for (std::size_t i = 0; i < outline.size() && best > 0.0; ++i)
      if (intersects({outline[i], outline[(i + 1) % outline.size()]}, segment)) best = 0.0;
  return best;
}

double gap(const Footprint& footprint, const Vec2& point) {
  if (!footprint.round()) return box_distance(footprint.to_local(point), footprint.half());
  if (contains(footprint, point)) return 0.0;
  const auto outline = footprint.outline();
  double best = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < outline.size(); ++i)
    best = std::min(best, distance({outline[i], outline[(i + 1) % outline.size()]}, point));
  return best;
}

bool contains(const Footprint& footprint, const Vec2& point) {
  const Vec2 local = footprint.to_local(point);
  if (!footprint.round())
    return std::abs(local.x()) <= footprint.half().x() &&
           std::abs(local.y()) <= footprint.half().y();
  return local.cwiseQuotient(footprint.half()).squaredNorm() <= 1.0;
}

double reach_along(const Footprint& footprint, const Vec2& direction) {
  const Vec2 local(std::abs(footprint.x_axis().dot(direction)),
                   std::abs(footprint.y_axis().dot(direction)));
  // An ellipse reaches less far than its box.
  return footprint.round() ? local.cwiseProduct(footprint.half()).norm()
                           : local.dot(footprint.half());
}

double ray_hit(const Footprint& footprint, const Vec2& origin, const Vec2& direction) {
  if (contains(footprint, origin)) return 0.0;
  double best = -1.0;
  const auto outline = footprint.outline();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 start = outline[i], edge = outline[(i + 1) % outline.size()] - start;
    const double denominator = cross(direction, edge);
    if (std::abs(denominator) < 1e-12) continue;
    const double along_ray = cross(start - origin, edge) / denominator;
    const double along_edge = cross(start - origin, direction) / denominator;
    if (along_ray < 0.0 || along_edge < -1e-9 || along_edge > 1.0 + 1e-9) continue;
    if (best < 0.0 || along_ray < best) best = along_ray;
  }
  return best;
}

}  // namespace roomgen
