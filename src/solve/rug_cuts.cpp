#include "rug_cuts.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace roomgen {

namespace {

constexpr double beyond = 0.05;      // by how much a rug reaches past what stands on it, where there is room
constexpr double before = 0.03;      // and stays away from what does not
constexpr double lying_off = 1.5;    // weight of a metre that a rug is moved
constexpr double shrinking = 1.2;    // and of a metre that it loses, against one that it gains
constexpr double least_side = 0.35;  // but for rugs that are smaller anyway
constexpr std::size_t most_spans = 250;  // along one axis

/// A rug along one axis.
struct Span {
  double low = 0.0, high = 0.0;
  double change = 0.0;
};

double change_of(double grown, double moved) {
  return (grown < 0.0 ? -shrinking * grown : grown) + lying_off * std::abs(moved);
}

// Where its two ends may come to lie along an axis, as what they are now and what is in the way suggest.
struct Ends {
  std::vector<double> low, high;
};

Ends ends_along(int axis, double half, std::span<const Bounds2> parts, std::span<const Vec2> corners) {
  Ends ends{{-half}, {half}};
  for (const auto& part : parts) {
    ends.low.insert(ends.low.end(), {part.low[axis] - beyond, part.low[axis], part.high[axis] + before});
    ends.high.insert(ends.high.end(), {part.high[axis] + beyond, part.high[axis], part.low[axis] - before});
  }
  for (const auto& corner : corners) {
    ends.low.push_back(corner[axis]);
    ends.high.push_back(corner[axis]);
  }
  return ends;
}

class SpansAlong {
 public:
  SpansAlong(double size, const RugRange& range)
      : size_(size), least_(std::max(range.least * size, std::min(size, least_side))), most_(range.most * size) {}

  void add(double low, double high) {
    const double size = high - low;
    if (size < least_ - 1e-9 || size > most_ + 1e-9) return;
    spans_.push_back({low, high, change_of(size - size_, 0.5 * (low + high))});
  }

  std::vector<Span> take() {
    std::sort(spans_.begin(), spans_.end(), [](const Span& a, const Span& b) {
      return std::tie(a.change, a.low, a.high) < std::tie(b.change, b.low, b.high);
    });
    const auto same = [](const Span& a, const Span& b) {
      return std::abs(a.low - b.low) < 1e-4 && std::abs(a.high - b.high) < 1e-4;
    };
    spans_.erase(std::unique(spans_.begin(), spans_.end(), same), spans_.end());
    if (spans_.size() > most_spans) spans_.resize(most_spans);
    return std::move(spans_);
  }

 private:
  double size_, least_, most_;
  std::vector<Span> spans_;
};

// Each end where something suggests it, the other one too, or moved along with it, or as far to its side.
std::vector<Span> spans_along(int axis, const Vec2& size, const RugRange& range,
                              std::span<const Bounds2> parts, std::span<const Vec2> corners) {
  const Ends ends = ends_along(axis, 0.5 * size[axis], parts, corners);
  SpansAlong spans(size[axis], range);
  for (const double low : ends.low) {
    spans.add(low, low + size[axis]);
    spans.add(low, -low);
    for (const double high : ends.high) spans.add(low, high);
  }
  for (const double high : ends.high) {
    spans.add(high - size[axis], high);
    spans.add(-high, high);
  }
  return spans.take();
}

std::vector<RugCut> rectangular_cuts(const Vec2& size, const RugRange& range,
                                     std::span<const Bounds2> parts, std::span<const Vec2> corners) {
  const auto across = spans_along(0, size, range, parts, corners);
  const auto along = spans_along(1, size, range, parts, corners);
  std::vector<RugCut> cuts;
  cuts.reserve(across.size() * along.size());
  for (const auto& x : across)
    for (const auto& y : along)
      cuts.push_back({{{x.low, y.low}, {x.high, y.high}}, x.change + y.change});
  return cuts;
}

// Larger or smaller as a whole, and a little to and fro.
std::vector<RugCut> round_cuts(const Vec2& size, const RugRange& range) {
  constexpr double step = 0.05;
  constexpr int farthest = 12;  // steps
  std::vector<RugCut> cuts;
  for (double factor = std::ceil(range.least / step) * step; factor <= range.most + 1e-9; factor += step)
    for (int i = -farthest; i <= farthest; ++i)
      for (int j = -farthest; j <= farthest; ++j) {
        const Vec2 at = step * Vec2(i, j), half = 0.5 * factor * size;
        cuts.push_back({{at - half, at + half}, change_of((factor - 1.0) * size.mean(), at.norm())});
      }
  return cuts;
}

}  // namespace

std::vector<RugCut> rug_cuts(const Vec2& size, bool round, const RugRange& range,
                             std::span<const Bounds2> parts, std::span<const Vec2> corners) {
  auto cuts = round ? round_cuts(size, range) : rectangular_cuts(size, range, parts, corners);
  std::stable_sort(cuts.begin(), cuts.end(),
                   [](const RugCut& a, const RugCut& b) { return a.change < b.change; });
  return cuts;
}

}  // namespace roomgen
