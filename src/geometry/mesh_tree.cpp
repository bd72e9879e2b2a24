#include "mesh_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "box_distance.h"

namespace roomgen {

namespace {

constexpr std::uint32_t most_in_leaf = 4;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double behind = -1e-6;   // as trimesh has it
constexpr double edge_slack = 1e-9;
constexpr double box_margin = 1e-9;
constexpr double across = 1e-12;   // a direction along which a ray does not move

// Where the ray enters the box, at the origin if it starts inside; infinite if it misses.
double entry(const Bounds3& box, const Ray& ray) {
  double enters = behind, leaves = infinite;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.low[axis] - box_margin - ray.origin[axis];
    const double high = box.high[axis] + box_margin - ray.origin[axis];
    const double speed = ray.direction[axis];
    if (std::abs(speed) < across) {
      if (low > 0.0 || high < 0.0) return infinite;
      continue;
    }
    enters = std::max(enters, std::min(low / speed, high / speed));
    leaves = std::min(leaves, std::max(low / speed, high / speed));
  }
  return enters <= leaves ? enters : infinite;
}

// Upwards, slightly slanted so that it meets no edge of axis-aligned meshes.
Ray slanted_ray(const Vec3& origin) {
  return {origin, Vec3(0.0123, 0.0071, 1.0).normalized()};
}

}  // namespace

// Halves by the middle of the facets along the longest side of the box.
class MeshTree::Build {
 public:
  Build(MeshTree& tree, std::vector<Facet> facets)
      : tree_(tree), facets_(std::move(facets)), order_(facets_.size()) {
    for (std::uint32_t k = 0; k < order_.size(); ++k) {
      order_[k] = k;
      boxes_.push_back(bounds(facets_[k]));
    }
    tree_.nodes_.reserve(facets_.size());
    tree_.facets_.reserve(facets_.size());
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
      tree_.nodes_[number].first = static_cast<std::uint32_t>(tree_.facets_.size());
      tree_.nodes_[number].count = to - from;
      for (std::uint32_t k = from; k < to; ++k) tree_.facets_.push_back(facets_[order_[k]]);
      return number;
    }
    const std::uint32_t middle = split(from, to, centres);
    const std::uint32_t left = divide(from, middle), right = divide(middle, to);
    tree_.nodes_[number].left = left;
    tree_.nodes_[number].right = right;
    return number;
  }

  std::uint32_t split(std::uint32_t from, std::uint32_t to, const Bounds3& centres) {
    int axis = 0;
    centres.size().maxCoeff(&axis);
    const std::uint32_t middle = from + (to - from) / 2;
    const auto place = [&](std::uint32_t k) { return boxes_[k].low[axis] + boxes_[k].high[axis]; };
    std::nth_element(order_.begin() + from, order_.begin() + middle, order_.begin() + to,
                     [&](std::uint32_t a, std::uint32_t b) {
                       const double first = place(a), second = place(b);
                       return first < second || (first == second && a < b);
                     });
    return middle;
  }

  MeshTree& tree_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> order_;
  std::vector<Bounds3> boxes_;
};

MeshTree::MeshTree(const Mesh& mesh) {
  std::vector<Facet> facets;
  facets.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) facets.push_back(facet(mesh, t));
  if (!facets.empty()) Build(*this, std::move(facets));
}

// Visits the facets of all leaves whose boxes, from the whole downwards, `enters` lets pass; ends
// when `visit` says so.
template <typename Enters, typename Visit>
void MeshTree::walk(Enters enters, Visit visit) const {
  std::array<std::uint32_t, 64> open;  // halving keeps them few
  std::size_t count = 0;
  if (!nodes_.empty()) open[count++] = 0;
  while (count > 0) {
    const Node& node = nodes_[open[--count]];
    if (!enters(node.box)) continue;
    if (!node.is_leaf()) {
      open[count++] = node.right;
      open[count++] = node.left;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
      if (visit(facets_[k])) return;
  }
}

std::optional<Vec3> MeshTree::closest_point(const Vec3& point, double limit) const {
  std::optional<Vec3> best;
  double squared = limit * limit;
  walk([&](const Bounds3& box) { return squared_distance(box, point) < squared; },
       [&](const Facet& facet) {
         const Vec3 found = roomgen::closest_point(facet, point);
         if (const double d = (found - point).squaredNorm(); d < squared) {
           squared = d;
           best = found;
         }
         return false;
       });
  return best;
}

bool MeshTree::within(const Vec3& point, double distance) const {
  const double squared = distance * distance;
  bool found = false;
  walk([&](const Bounds3& box) { return squared_distance(box, point) <= squared; },
       [&](const Facet& facet) {
         found = (roomgen::closest_point(facet, point) - point).squaredNorm() <= squared;
         return found;
       });
  return found;
}

std::optional<double> MeshTree::first_hit(const Ray& ray) const {
  double best = infinite;
  walk([&](const Bounds3& box) { return entry(box, ray) < best; },
       [&](const Facet& facet) {
         const auto met = crossing(facet, ray, edge_slack);
         if (met && met->at >= behind) best = std::min(best, met->at);
         return false;
       });
  if (best == infinite) return std::nullopt;
  return std::max(best, 0.0);
}

Enclosure MeshTree::around(const Vec3& point) const {
  const Ray ray = slanted_ray(point);
  Enclosure result;
  walk([&](const Bounds3& box) { return entry(box, ray) < infinite; },
       [&](const Facet& facet) {
         const auto met = crossing(facet, ray);
         if (met && met->at > 0.0) {
           ++result.crossings;
           result.winding += met->outward ? 1 : -1;
         }
         return false;
       });
  return result;
}

}  // namespace roomgen
