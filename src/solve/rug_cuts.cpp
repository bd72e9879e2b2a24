#include <algorithm>
#include <cmath>
#include <tuple>

#include "rug_place.h"

namespace roomgen {

namespace {

constexpr double beyond = 0.05;      // by how much a rug reaches past what stands on it, where there is room
constexpr double before = 0.03;      // and stays away from what does not
constexpr double lying_off = 1.5;    // weight of a metre that a rug is moved
constexpr double shrinking = 1.2;    // and of a metre that it loses, against one that it gains
constexpr double least_side = 0.35;  // but for rugs that are smaller anyway
constexpr std::size_t most_ends = 24;  // on one side

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

// Each once, and of very many those next to where the end was.
std::vector<double> nearest(std::vector<double> ends, double was) {
  std::sort(ends.begin(), ends.end());
  const auto same = [](double a, double b) { return b - a < 1e-4; };
  ends.erase(std::unique(ends.begin(), ends.end(), same), ends.end());
  std::stable_sort(ends.begin(), ends.end(),
                   [&](double a, double b) { return std::abs(a - was) < std::abs(b - was); });
  if (ends.size() > most_ends) ends.resize(most_ends);
  return ends;
}

Ends ends_along(int axis, double half, const AboutRug& about) {
  Ends ends{{-half}, {half}};
  for (const auto& thing : about.things) {
    ends.low.push_back(thing.low[axis] - beyond);
    ends.high.push_back(thing.high[axis] + beyond);
  }
  for (const auto& part : about.parts) {
    ends.low.push_back(part.high[axis] + before);
    ends.high.push_back(part.low[axis] - before);
  }
  for (const auto& corner : about.corners) {
    ends.low.push_back(corner[axis]);
    ends.high.push_back(corner[axis]);
  }
  return {nearest(std::move(ends.low), -half), nearest(std::move(ends.high), half)};
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
    return std::move(spans_);
  }

 private:
  double size_, least_, most_;
  std::vector<Span> spans_;
};

// Each end where something suggests it, the other one too, or moved along with it, or as far to its side.
std::vector<Span> spans_along(int axis, const Vec2& size, const RugRange& range, const AboutRug& about) {
  const Ends ends = ends_along(axis, 0.5 * size[axis], about);
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

std::vector<RugCut> rectangular_cuts(const Vec2& size, const RugRange& range, const AboutRug& about) {
  const auto across = spans_along(0, size, range, about);
  const auto along = spans_along(1, size, range, about);
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

std::vector<RugCut> rug_cuts(const Vec2& size, bool round, const RugRange& range, const AboutRug& about) {
  auto cuts = round ? round_cuts(size, range) : rectangular_cuts(size, range, about);
  std::stable_sort(cuts.begin(), cuts.end(),
                   [](const RugCut& a, const RugCut& b) { return a.change < b.change; });
  return cuts;
}

}  // namespace roomgen
