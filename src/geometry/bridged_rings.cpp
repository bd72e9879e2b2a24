#include <algorithm>

#include "rings.h"

namespace roomgen::detail {

namespace {

// Joins a hole to the ring around it by a pair of edges there and back.
class Bridge {
 public:
  Bridge(const std::vector<Vec2>& points, const Ring& ring, const std::vector<Ring>& holes)
      : points_(points), ring_(ring), holes_(holes) {}

  // The ring's place that sees the hole's point, the nearest first; the nearest of all when
  // rounding hides them all.
  std::size_t place(Index hole_point) const {
    std::vector<std::size_t> order(ring_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const Vec2& from = points_[hole_point];
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return (points_[ring_[a]] - from).squaredNorm() < (points_[ring_[b]] - from).squaredNorm();
    });
    for (auto place : order)
      if (opens_towards(place, from) && is_free({points_[ring_[place]], from})) return place;
    return order.front();
  }

 private:
  bool opens_towards(std::size_t place, const Vec2& target) const {
    const std::size_t n = ring_.size();
    const Vec2& before = points_[ring_[(place + n - 1) % n]];
    const Vec2& here = points_[ring_[place]];
    const Vec2& after = points_[ring_[(place + 1) % n]];
    const bool left_of_in = turn(before, here, target) > 0;
    const bool left_of_out = cross(after - here, target - here) > 0;
    return turn(before, here, after) > 0 ? left_of_in && left_of_out : left_of_in || left_of_out;
  }

  bool is_free(const Segment& bridge) const {
    if (crosses(bridge, ring_)) return false;
    return std::none_of(holes_.begin(), holes_.end(),
                        [&](const Ring& hole) { return crosses(bridge, hole); });
  }

  bool crosses(const Segment& bridge, const Ring& ring) const {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Segment edge{points_[ring[i]], points_[ring[(i + 1) % ring.size()]]};
      const bool shares_end =
          edge.a == bridge.a || edge.a == bridge.b || edge.b == bridge.a || edge.b == bridge.b;
      if (!shares_end && boxes_touch(edge, bridge) && intersects(edge, bridge)) return true;
    }
    return false;
  }

  const std::vector<Vec2>& points_;
  const Ring& ring_;
  const std::vector<Ring>& holes_;
};

}  // namespace

bool boxes_touch(const Segment& s, const Segment& t) {
  return std::max(s.a.x(), s.b.x()) >= std::min(t.a.x(), t.b.x()) &&
         std::max(t.a.x(), t.b.x()) >= std::min(s.a.x(), s.b.x()) &&
         std::max(s.a.y(), s.b.y()) >= std::min(t.a.y(), t.b.y()) &&
         std::max(t.a.y(), t.b.y()) >= std::min(s.a.y(), s.b.y());
}

Ring bridged(const std::vector<Vec2>& points, Ring ring, std::vector<Ring> holes) {
  const auto is_further_left = [&](Index a, Index b) { return points[a].x() < points[b].x(); };
  // Holes begin at their rightmost points and are taken from the right, so that each finds the ring
  // or a hole that is already part of it.
  for (auto& hole : holes)
    std::rotate(hole.begin(), std::max_element(hole.begin(), hole.end(), is_further_left),
                hole.end());
  std::stable_sort(holes.begin(), holes.end(), [&](const Ring& a, const Ring& b) {
    return is_further_left(b.front(), a.front());
  });
  while (!holes.empty()) {
    Ring hole = holes.front();
    const std::size_t place = Bridge(points, ring, holes).place(hole.front());
    const Index anchor = ring[place];
    hole.push_back(hole.front());
    hole.push_back(anchor);
    ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(place) + 1, hole.begin(), hole.end());
    holes.erase(holes.begin());
  }
  return ring;
}

}  // namespace roomgen::detail
