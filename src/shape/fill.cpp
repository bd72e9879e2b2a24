#include "fill.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "roomgen/geometry/polygon.h"
#include "weld.h"

namespace roomgen::shape {

namespace {

using Index = std::uint32_t;
using Ring = std::vector<Index>;

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return cross(b - a, c - b);
}

bool boxes_overlap(const Segment& s, const Segment& t) {
  return std::max(s.a.x(), s.b.x()) >= std::min(t.a.x(), t.b.x()) &&
         std::max(t.a.x(), t.b.x()) >= std::min(s.a.x(), s.b.x()) &&
         std::max(s.a.y(), s.b.y()) >= std::min(t.a.y(), t.b.y()) &&
         std::max(t.a.y(), t.b.y()) >= std::min(s.a.y(), s.b.y());
}

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
      if (!shares_end && boxes_overlap(edge, bridge) && intersects(edge, bridge)) return true;
    }
    return false;
  }

  const std::vector<Vec2>& points_;
  const Ring& ring_;
  const std::vector<Ring>& holes_;
};

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

// Ear clipping that always takes the roundest ear, so that points in line do not end up as slivers.
class EarClipper {
 public:
  EarClipper(const std::vector<Vec2>& points, Ring ring) : points_(points), ring_(std::move(ring)) {
    const std::size_t n = ring_.size();
    for (std::size_t i = 0; i < n; ++i) {
      before_.push_back((i + n - 1) % n);
      after_.push_back((i + 1) % n);
    }
    for (std::size_t i = 0; i < n; ++i) quality_.push_back(quality(i));
  }

  void clip(std::vector<Triangle>& triangles) {
    std::vector<std::size_t> left(ring_.size());
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
    while (left.size() >= 3) {
      const auto best = std::max_element(
          left.begin(), left.end(), [this](auto a, auto b) { return quality_[a] < quality_[b]; });
      const std::size_t ear = *best, before = before_[ear], after = after_[ear];
      left.erase(best);
      triangles.push_back({ring_[before], ring_[ear], ring_[after]});
      after_[before] = after;
      before_[after] = before;
      quality_[before] = quality(before);
      quality_[after] = quality(after);
    }
  }

 private:
  const Vec2& point(std::size_t place) const { return points_[ring_[place]]; }

  // Twice the area in squares of the longest side; -1 for what is no ear.
  double quality(std::size_t place) const {
    const Vec2 &a = point(before_[place]), &b = point(place), &c = point(after_[place]);
    const double twice_area = turn(a, b, c);
    if (twice_area <= 0 || is_occupied(place, a, b, c)) return -1.0;
    return twice_area /
           std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  }

  bool is_occupied(std::size_t place, const Vec2& a, const Vec2& b, const Vec2& c) const {
    for (std::size_t j = after_[after_[place]]; j != before_[place]; j = after_[j]) {
      const Vec2& p = point(j);
      if (p == a || p == b || p == c) continue;
      if (cross(b - a, p - a) >= 0 && cross(c - b, p - b) >= 0 && cross(a - c, p - c) >= 0)
        return true;
    }
    return false;
  }

  const std::vector<Vec2>& points_;
  Ring ring_;
  std::vector<std::size_t> before_, after_;
  std::vector<double> quality_;
};

// Turns diagonals until each is the better one of its quadrangle (Lawson 1977).
class Flipper {
 public:
  Flipper(const std::vector<Vec2>& points, std::vector<Triangle>& triangles)
      : points_(points), triangles_(triangles) {
    for (std::size_t t = 0; t < triangles.size(); ++t) remember(t);
  }

  void run() {
    bool changed = true;
    for (int round = 0; changed && round < 64; ++round) {
      changed = false;
      for (std::size_t t = 0; t < triangles_.size(); ++t)
        for (int k = 0; k < 3; ++k) changed = flip(t, k) || changed;
    }
  }

 private:
  void remember(std::size_t t) {
    for (int k = 0; k < 3; ++k)
      owner_[directed_edge(triangles_[t][k], triangles_[t][(k + 1) % 3])] = t;
  }

  bool flip(std::size_t t, int k) {
    const Index a = triangles_[t][k], b = triangles_[t][(k + 1) % 3],
                c = triangles_[t][(k + 2) % 3];
    const auto beyond = owner_.find(directed_edge(b, a));
    if (beyond == owner_.end()) return false;
    const std::size_t other = beyond->second;
    Index d = c;
    for (auto v : triangles_[other])
      if (v != a && v != b) d = v;
    if (d == c || !is_better(points_[a], points_[b], points_[c], points_[d])) return false;
    if (owner_.count(directed_edge(c, d)) || owner_.count(directed_edge(d, c))) return false;
    owner_.erase(directed_edge(a, b));
    owner_.erase(directed_edge(b, a));
    triangles_[t] = {a, d, c};
    triangles_[other] = {d, b, c};
    remember(t);
    remember(other);
    return true;
  }

  static bool is_better(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const double longest = std::max((a - b).squaredNorm(), (c - d).squaredNorm());
    const double least = 1e-9 * longest;
    if (turn(a, d, c) <= least || turn(d, b, c) <= least) return false;
    // The angles that see the diagonal add up to more than half a turn.
    const auto angle = [](const Vec2& apex, const Vec2& p, const Vec2& q) {
      return std::atan2(std::abs(cross(p - apex, q - apex)), (p - apex).dot(q - apex));
    };
    return angle(c, a, b) + angle(d, a, b) > pi + 1e-6;
  }

  const std::vector<Vec2>& points_;
  std::vector<Triangle>& triangles_;
  std::unordered_map<std::uint64_t, std::size_t> owner_;
};

// The smallest outer loop around each hole; holes without one are left out.
std::vector<std::vector<std::size_t>> holes_of(const std::vector<Loop>& loops,
                                               const std::vector<double>& areas) {
  std::vector<std::vector<std::size_t>> result(loops.size());
  for (std::size_t hole = 0; hole < loops.size(); ++hole) {
    if (areas[hole] >= 0) continue;
    std::optional<std::size_t> best;
    for (std::size_t outer = 0; outer < loops.size(); ++outer)
      if (areas[outer] > -areas[hole] && (!best || areas[outer] < areas[*best]) &&
          contains(Polygon{loops[outer]}, loops[hole].front()))
        best = outer;
    if (best) result[*best].push_back(hole);
  }
  return result;
}

}  // namespace

bool is_simple(const Loop& loop) {
  const std::size_t n = loop.size();
  const auto edge = [&](std::size_t i) { return Segment{loop[i], loop[(i + 1) % n]}; };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (boxes_overlap(edge(i), edge(j)) && intersects(edge(i), edge(j))) return false;
    }
  return n >= 3;
}

std::vector<Triangle> fill(const std::vector<Loop>& loops) {
  std::vector<Vec2> points;
  std::vector<Ring> rings;
  std::vector<double> areas;
  for (const auto& loop : loops) {
    auto& ring = rings.emplace_back();
    for (const auto& point : loop) {
      ring.push_back(static_cast<Index>(points.size()));
      points.push_back(point);
    }
    areas.push_back(signed_area(loop));
  }
  const auto holes = holes_of(loops, areas);
  std::vector<Triangle> triangles;
  for (std::size_t outer = 0; outer < loops.size(); ++outer) {
    if (areas[outer] <= 0) continue;
    std::vector<Ring> inside;
    for (auto hole : holes[outer]) inside.push_back(rings[hole]);
    EarClipper(points, bridged(points, rings[outer], inside)).clip(triangles);
  }
  Flipper(points, triangles).run();
  return triangles;
}

}  // namespace roomgen::shape
