#include "ray_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace roomgen {

namespace {

constexpr std::size_t leaf_size = 4;
constexpr double behind = -1e-6;  // trimesh takes hits up to this
constexpr double infinite = std::numeric_limits<double>::infinity();

// Where the ray enters the box; infinite if it misses.
double entry(const Bounds3& box, const Vec3& origin, const Vec3& direction) {
  double low = behind, high = infinite;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) < 1e-12) {
      if (origin[axis] < box.low[axis] - 1e-9 || origin[axis] > box.high[axis] + 1e-9)
        return infinite;
      continue;
    }
    double near = (box.low[axis] - origin[axis]) / direction[axis];
    double far = (box.high[axis] - origin[axis]) / direction[axis];
    if (near > far) std::swap(near, far);
    low = std::max(low, near - 1e-9);
    high = std::min(high, far + 1e-9);
  }
  return low <= high ? low : infinite;
}

// Moeller and Trumbore 1997.
double hit(const Vec3& a, const Vec3& u, const Vec3& v, const Vec3& origin, const Vec3& direction) {
  const Vec3 p = direction.cross(v);
  const double determinant = u.dot(p);
  if (std::abs(determinant) < 1e-15) return infinite;
  const Vec3 s = origin - a;
  const double alpha = s.dot(p) / determinant;
  const Vec3 q = s.cross(u);
  const double beta = direction.dot(q) / determinant;
  constexpr double edge = -1e-9;
  if (alpha < edge || beta < edge || alpha + beta > 1 - edge) return infinite;
  const double t = v.dot(q) / determinant;
  return t >= behind ? t : infinite;
}

double squared_distance(const Bounds3& box, const Vec3& point) {
  return (point - point.cwiseMax(box.low).cwiseMin(box.high)).squaredNorm();
}

// Ericson, Real-Time Collision Detection, 5.1.5.
Vec3 closest_on(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const double whole = va + vb + vc;
  if (std::abs(whole) < 1e-30) return a;
  return a + vb / whole * ab + vc / whole * ac;
}

}  // namespace

RayTree::RayTree(const Mesh& mesh) {
  triangles_.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    triangles_.push_back({mesh.positions[t[0]].cast<double>(), mesh.positions[t[1]].cast<double>(),
                          mesh.positions[t[2]].cast<double>()});
  if (!triangles_.empty()) build(0, triangles_.size());
}

void RayTree::build(std::size_t first, std::size_t count) {
  const std::size_t index = nodes_.size();
  nodes_.emplace_back();
  Bounds3 box;
  for (std::size_t i = first; i < first + count; ++i)
    for (const Vec3* corner : {&triangles_[i].a, &triangles_[i].b, &triangles_[i].c})
      box.add(*corner);
  nodes_[index].box = box;
  if (count <= leaf_size) {
    nodes_[index].first = first;
    nodes_[index].count = count;
    return;
  }
  Eigen::Index axis = 0;
  box.size().maxCoeff(&axis);
  const auto middle = triangles_.begin() + static_cast<std::ptrdiff_t>(first + count / 2);
  std::nth_element(triangles_.begin() + static_cast<std::ptrdiff_t>(first), middle,
                   triangles_.begin() + static_cast<std::ptrdiff_t>(first + count),
                   [axis](const Corners& s, const Corners& t) {
                     return s.a[axis] + s.b[axis] + s.c[axis] < t.a[axis] + t.b[axis] + t.c[axis];
                   });
  build(first, count / 2);
  nodes_[index].right = nodes_.size();
  build(first + count / 2, count - count / 2);
}

std::optional<double> RayTree::first_hit(const Vec3& origin, const Vec3& direction) const {
  double best = infinite;
  std::vector<std::size_t> open;
  if (!nodes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const Node& node = nodes_[open.back()];
    const std::size_t index = open.back();
    open.pop_back();
    if (entry(node.box, origin, direction) > std::min(best, 1e300)) continue;
    for (std::size_t i = node.first; i < node.first + node.count; ++i) {
      const Corners& t = triangles_[i];
      best = std::min(best, hit(t.a, t.b - t.a, t.c - t.a, origin, direction));
    }
    if (node.count > 0) continue;
    open.push_back(node.right);
    open.push_back(index + 1);
  }
  if (best == infinite) return std::nullopt;
  return std::max(best, 0.0);
}

Vec3 RayTree::closest(const Vec3& point) const {
  Vec3 best = triangles_.front().a;
  double least = (best - point).squaredNorm();
  std::vector<std::size_t> open{0};
  while (!open.empty()) {
    const std::size_t index = open.back();
    const Node& node = nodes_[index];
    open.pop_back();
    if (squared_distance(node.box, point) >= least) continue;
    for (std::size_t i = node.first; i < node.first + node.count; ++i) {
      const Corners& t = triangles_[i];
      const Vec3 candidate = closest_on(t.a, t.b, t.c, point);
      if (const double d = (candidate - point).squaredNorm(); d < least) {
        least = d;
        best = candidate;
      }
    }
    if (node.count > 0) continue;
    open.push_back(node.right);
    open.push_back(index + 1);
  }
  return best;
}

}  // namespace roomgen
