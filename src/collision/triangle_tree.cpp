#include "triangle_tree.h"

#include <fcl/narrowphase/detail/primitive_shape_algorithm/triangle_distance.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace roomgen::detail {

namespace {

constexpr std::uint32_t most_in_leaf = 4;

double squared_distance(const Bounds3& a, const Bounds3& b) {
  return (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(Vec3::Zero()).squaredNorm();
}

double squared_distance(const Bounds3& box, const Vec3& point) {
  return (box.low - point).cwiseMax(point - box.high).cwiseMax(Vec3::Zero()).squaredNorm();
}

// Upwards, slightly slanted so that it meets no edge of axis-aligned meshes.
const Vec3& ray_direction() {
  static const Vec3 direction = Vec3(0.0123, 0.0071, 1.0).normalized();
  return direction;
}

bool ray_meets(const Bounds3& box, const Vec3& from) {
  constexpr double margin = 1e-9;
  double enters = 0.0, leaves = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double speed = ray_direction()[axis];  // all are above 0
    enters = std::max(enters, (box.low[axis] - margin - from[axis]) / speed);
    leaves = std::min(leaves, (box.high[axis] + margin - from[axis]) / speed);
  }
  return enters <= leaves;
}

// Moeller and Trumbore 1997.
int crossing(const Corners& t, const Vec3& point) {
  const Vec3& direction = ray_direction();
  const Vec3 u = t.b - t.a, v = t.c - t.a;
  const Vec3 p = direction.cross(v);
  const double determinant = u.dot(p);
  if (std::abs(determinant) < 1e-15) return 0;
  const Vec3 s = point - t.a;
  const double alpha = s.dot(p) / determinant;
  if (alpha < 0 || alpha > 1) return 0;
  const Vec3 q = s.cross(u);
  const double beta = direction.dot(q) / determinant;
  if (beta < 0 || alpha + beta > 1 || v.dot(q) / determinant <= 0) return 0;
  return determinant < 0 ? 1 : -1;
}

// All of t lies further from the plane of s than the root of `squared`, on one side of it.
bool beyond_plane(const Corners& s, const Corners& t, double squared) {
  const Vec3 normal = (s.b - s.a).cross(s.c - s.a);
  const double a = normal.dot(t.a - s.a), b = normal.dot(t.b - s.a), c = normal.dot(t.c - s.a);
  const double above = std::min({a, b, c}), below = -std::max({a, b, c});
  const double least = std::max(above, below);
  // Slivers have no plane; the margin is for what is lost in rounding.
  return least > 0.0 && least * least > 1.0001 * squared * normal.squaredNorm() + 1e-24;
}

/// Boxes still to be looked at; halving keeps them few.
class Open {
 public:
  explicit Open(bool any) : count_(any ? 1 : 0) {}
  bool empty() const { return count_ == 0; }
  std::uint32_t take() { return nodes_[--count_]; }
  void add(std::uint32_t node) { nodes_[count_++] = node; }

 private:
  std::array<std::uint32_t, 64> nodes_{};
  std::size_t count_;
};

}  // namespace

Bounds3 box_of(const Corners& t) {
  return {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)};
}

// Ericson, Real-Time Collision Detection, 5.1.5.
Vec3 closest(const Corners& t, const Vec3& p) {
  const Vec3 ab = t.b - t.a, ac = t.c - t.a, ap = p - t.a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return t.a;
  const Vec3 bp = p - t.b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return t.b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return t.a + d1 / (d1 - d3) * ab;
  const Vec3 cp = p - t.c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return t.c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return t.a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6)
    return t.b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t.c - t.b);
  const double sum = va + vb + vc;
  return sum > 0 ? Vec3(t.a + (vb * ab + vc * ac) / sum) : t.a;
}

// Halves by the middle of the triangles along the longest side of the box.
class TriangleTree::Build {
 public:
  Build(TriangleTree& tree, std::vector<Corners> triangles)
      : tree_(tree), triangles_(std::move(triangles)), order_(triangles_.size()) {
    for (std::uint32_t k = 0; k < order_.size(); ++k) {
      order_[k] = k;
      boxes_.push_back(box_of(triangles_[k]));
    }
    tree_.nodes_.reserve(triangles_.size());
    tree_.triangles_.reserve(triangles_.size());
    divide(0, static_cast<std::uint32_t>(order_.size()));
  }

 private:
  std::uint32_t divide(std::uint32_t from, std::uint32_t to) {
    const auto number = static_cast<std::uint32_t>(tree_.nodes_.size());
    Node node;
    Bounds3 centres;
    for (std::uint32_t k = from; k < to; ++k) {
      const Bounds3& box = boxes_[order_[k]];
      node.box.low = node.box.low.cwiseMin(box.low);
      node.box.high = node.box.high.cwiseMax(box.high);
      centres.add(box.center());
    }
    tree_.nodes_.push_back(node);
    if (to - from <= most_in_leaf) {
      tree_.nodes_[number].first = static_cast<std::uint32_t>(tree_.triangles_.size());
      tree_.nodes_[number].count = to - from;
      for (std::uint32_t k = from; k < to; ++k) tree_.triangles_.push_back(triangles_[order_[k]]);
      return number;
    }
    int axis = 0;
    centres.size().maxCoeff(&axis);
    const std::uint32_t middle = from + (to - from) / 2;
    const auto place = [&](std::uint32_t k) { return boxes_[k].low[axis] + boxes_[k].high[axis]; };
    std::nth_element(order_.begin() + from, order_.begin() + middle, order_.begin() + to,
                     [&](std::uint32_t a, std::uint32_t b) {
                       const double first = place(a), second = place(b);
                       return first < second || (first == second && a < b);
                     });
    const std::uint32_t left = divide(from, middle), right = divide(middle, to);
    tree_.nodes_[number].left = left;
    tree_.nodes_[number].right = right;
    return number;
  }

  TriangleTree& tree_;
  std::vector<Corners> triangles_;
  std::vector<std::uint32_t> order_;
  std::vector<Bounds3> boxes_;
};

// Pairs of boxes, the nearer half first; what is not nearer than the best is left out.
class TriangleTree::Nearest {
 public:
  Nearest(const TriangleTree& a, const TriangleTree& b, double enough, NearestPoints& best)
      : a_(a), b_(b), enough_(enough), best_(best), squared_(best.distance * best.distance) {}

  bool run() {
    visit(0, 0, squared_distance(a_.nodes_[0].box, b_.nodes_[0].box));
    return found_;
  }

 private:
  void visit(std::uint32_t a, std::uint32_t b, double apart) {
    if (apart >= squared_ || (found_ && best_.distance <= enough_)) return;
    const Node &first = a_.nodes_[a], &second = b_.nodes_[b];
    if (first.is_leaf() && second.is_leaf()) return compare(first, second);
    const bool halve_first =
        second.is_leaf() ||
        (!first.is_leaf() && first.box.size().squaredNorm() >= second.box.size().squaredNorm());
    if (halve_first) {
      const double left = squared_distance(a_.nodes_[first.left].box, second.box);
      const double right = squared_distance(a_.nodes_[first.right].box, second.box);
      if (left <= right)
        visit(first.left, b, left), visit(first.right, b, right);
      else
        visit(first.right, b, right), visit(first.left, b, left);
    } else {
      const double left = squared_distance(first.box, b_.nodes_[second.left].box);
      const double right = squared_distance(first.box, b_.nodes_[second.right].box);
      if (left <= right)
        visit(a, second.left, left), visit(a, second.right, right);
      else
        visit(a, second.right, right), visit(a, second.left, left);
    }
  }

  void compare(const Node& first, const Node& second) {
    for (std::uint32_t k = first.first; k < first.first + first.count; ++k) {
      const Corners& s = a_.triangles_[k];
      const Bounds3 box = box_of(s);
      if (squared_distance(box, second.box) >= squared_) continue;
      for (std::uint32_t m = second.first; m < second.first + second.count; ++m) {
        const Corners& t = b_.triangles_[m];
        if (squared_distance(box, box_of(t)) >= squared_) continue;
        if (beyond_plane(s, t, squared_) || beyond_plane(t, s, squared_)) continue;
        Vec3 p, q;
        const double distance =
            fcl::detail::TriangleDistanced::triDistance(s.a, s.b, s.c, t.a, t.b, t.c, p, q);
        if (distance >= best_.distance) continue;
        best_ = {distance, p, q};
        squared_ = distance * distance;
        found_ = true;
        if (distance <= enough_) return;
      }
    }
  }

  const TriangleTree &a_, &b_;
  double enough_;
  NearestPoints& best_;
  double squared_;
  bool found_ = false;
};

TriangleTree::TriangleTree(const Mesh& mesh) {
  std::vector<Corners> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    triangles.push_back({mesh.positions[t[0]].cast<double>(), mesh.positions[t[1]].cast<double>(),
                         mesh.positions[t[2]].cast<double>()});
  if (!triangles.empty()) Build(*this, std::move(triangles));
}

bool TriangleTree::nearest(const TriangleTree& other, NearestPoints& nearest, double enough) const {
  if (nodes_.empty() || other.nodes_.empty()) return false;
  return Nearest(*this, other, enough, nearest).run();
}

bool TriangleTree::within(const Vec3& point, double distance) const {
  const double squared = distance * distance;
  Open open(!nodes_.empty());
  while (!open.empty()) {
    const Node& node = nodes_[open.take()];
    if (squared_distance(node.box, point) > squared) continue;
    if (!node.is_leaf()) {
      open.add(node.right);
      open.add(node.left);
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
      if ((closest(triangles_[k], point) - point).squaredNorm() <= squared) return true;
  }
  return false;
}

int TriangleTree::winding(const Vec3& point) const {
  int around = 0;
  Open open(!nodes_.empty());
  while (!open.empty()) {
    const Node& node = nodes_[open.take()];
    if (!ray_meets(node.box, point)) continue;
    if (!node.is_leaf()) {
      open.add(node.right);
      open.add(node.left);
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
      around += crossing(triangles_[k], point);
  }
  return around;
}

}  // namespace roomgen::detail
