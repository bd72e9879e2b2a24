// The nearest points of two trees: pairs of boxes, the nearer half first.
#include <Eigen/Geometry>
#include <algorithm>

#include "box_distance.h"
#include "mesh_tree.h"

namespace roomgen {

namespace {

// All of t lies further from the plane of s than the root of `squared`, on one side of it.
bool beyond_plane(const Facet& s, const Facet& t, double squared) {
  const Vec3 normal = (s.b - s.a).cross(s.c - s.a);
  const double a = normal.dot(t.a - s.a), b = normal.dot(t.b - s.a), c = normal.dot(t.c - s.a);
  const double above = std::min({a, b, c}), below = -std::max({a, b, c});
  const double least = std::max(above, below);
  // Slivers have no plane; the margin is for what is lost in rounding.
  return least > 0.0 && least * least > 1.0001 * squared * normal.squaredNorm() + 1e-24;
}

}  // namespace

// What is not nearer than the best is left out.
class MeshTree::Nearest {
 public:
  Nearest(const MeshTree& a, const MeshTree& b, double enough, NearestPoints& best)
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
    if (halve_first)
      visit_both({first.left, b}, {first.right, b});
    else
      visit_both({a, second.left}, {a, second.right});
  }

  struct Pair {
    std::uint32_t a, b;
  };
  void visit_both(const Pair& one, const Pair& two) {
    const double first = apart(one), second = apart(two);
    if (first <= second)
      visit(one.a, one.b, first), visit(two.a, two.b, second);
    else
      visit(two.a, two.b, second), visit(one.a, one.b, first);
  }
  double apart(const Pair& pair) const {
    return squared_distance(a_.nodes_[pair.a].box, b_.nodes_[pair.b].box);
  }

  void compare(const Node& first, const Node& second) {
    for (std::uint32_t k = first.first; k < first.first + first.count; ++k) {
      const Facet& s = a_.facets_[k];
      const Bounds3 box = bounds(s);
      if (squared_distance(box, second.box) >= squared_) continue;
      for (std::uint32_t m = second.first; m < second.first + second.count; ++m) {
        const Facet& t = b_.facets_[m];
        if (squared_distance(box, bounds(t)) >= squared_) continue;
        if (beyond_plane(s, t, squared_) || beyond_plane(t, s, squared_)) continue;
        const NearestPoints found = nearest_points(s, t);
        if (found.distance >= best_.distance) continue;
        best_ = found;
        squared_ = found.distance * found.distance;
        found_ = true;
        if (found.distance <= enough_) return;
      }
    }
  }

  const MeshTree &a_, &b_;
  double enough_;
  NearestPoints& best_;
  double squared_;
  bool found_ = false;
};

bool MeshTree::nearest(const MeshTree& other, NearestPoints& nearest, double enough) const {
  if (nodes_.empty() || other.nodes_.empty()) return false;
  return Nearest(*this, other, enough, nearest).run();
}

}  // namespace roomgen
