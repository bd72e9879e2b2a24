#include "roomgen/geometry/footprint.h"

#include <algorithm>
#include <limits>

namespace roomgen {

namespace {

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

}  // namespace

Footprint::Footprint(const Vec2& center, const Vec2& size, double yaw, bool round)
    : center_(center), half_(0.5 * size), yaw_(yaw), cos_(std::cos(yaw)), sin_(std::sin(yaw)) {
  if (round) {
    count_ = round_sides;
    // Edges touch the ellipse at their middles, four of them on the axes.
    const double stretch = 1.0 / std::cos(pi / round_sides);
    for (std::size_t i = 0; i < round_sides; ++i) {
      const double angle = 2.0 * pi * (static_cast<double>(i) + 0.5) / round_sides;
      corners_[i] = to_world({stretch * half_.x() * std::cos(angle),
                              stretch * half_.y() * std::sin(angle)});
    }
  } else {
    corners_[0] = to_world({half_.x(), half_.y()});
    corners_[1] = to_world({-half_.x(), half_.y()});
    corners_[2] = to_world({-half_.x(), -half_.y()});
    corners_[3] = to_world({half_.x(), -half_.y()});
  }
  for (const auto& corner : outline()) bounds_.add(corner);
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
  return !separated_by_edge_of(a, b, tolerance) && !separated_by_edge_of(b, a, tolerance);
}

double gap(const Footprint& a, const Footprint& b) {
  if (overlaps(a, b, 0.0)) return 0.0;
  // Convex and apart: the nearest points are a corner of one and an edge of the other.
  double best = std::numeric_limits<double>::max();
  const auto from_corners_to_edges = [&best](const Footprint& p, const Footprint& q) {
    const auto edges = q.outline();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Segment edge{edges[i], edges[(i + 1) % edges.size()]};
      for (const auto& corner : p.outline()) best = std::min(best, distance(edge, corner));
    }
  };
  from_corners_to_edges(a, b);
  from_corners_to_edges(b, a);
  return best;
}

double gap(const Footprint& footprint, const Segment& segment) {
  if (contains(footprint, segment.a)) return 0.0;
  double best = std::numeric_limits<double>::max();
  const auto outline = footprint.outline();
  for (std::size_t i = 0; i < outline.size(); ++i)
    best = std::min(best, distance(Segment{outline[i], outline[(i + 1) % outline.size()]}, segment));
  return best;
}

double gap(const Footprint& footprint, const Vec2& point) {
  if (!footprint.round()) {
    const Vec2 outside = (footprint.to_local(point).cwiseAbs() - footprint.half()).cwiseMax(0.0);
    return outside.norm();
  }
  return gap(footprint, Segment{point, point});
}

bool contains(const Footprint& footprint, const Vec2& point) {
  const Vec2 local = footprint.to_local(point);
  if (!footprint.round())
    return std::abs(local.x()) <= footprint.half().x() &&
           std::abs(local.y()) <= footprint.half().y();
  return local.cwiseQuotient(footprint.half()).squaredNorm() <= 1.0;
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
