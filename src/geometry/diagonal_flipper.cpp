#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "rings.h"

namespace roomgen::detail {

namespace {

class DiagonalFlipper {
 public:
  DiagonalFlipper(const std::vector<Vec2>& points, std::vector<Triangle>& triangles)
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

}  // namespace

void flip_diagonals(const std::vector<Vec2>& points, std::vector<Triangle>& triangles) {
  DiagonalFlipper(points, triangles).run();
}

}  // namespace roomgen::detail
