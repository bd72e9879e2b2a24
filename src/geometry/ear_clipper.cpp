#include <algorithm>

#include "rings.h"

namespace roomgen::detail {

namespace {

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

}  // namespace

void clip_ears(const std::vector<Vec2>& points, Ring ring, std::vector<Triangle>& triangles) {
  EarClipper(points, std::move(ring)).clip(triangles);
}

}  // namespace roomgen::detail
