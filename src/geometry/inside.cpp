#include "inside.h"

#include <algorithm>

namespace roomgen {

namespace {

constexpr std::size_t edges_a_band = 4, most_bands = 128;

}  // namespace

Inside::Inside(const Polygon& polygon) {
  const Bounds2 box = bounds(polygon);
  low_ = box.low.y();
  high_ = box.high.y();
  bands_.resize(std::clamp<std::size_t>(polygon.size() / edges_a_band, 1, most_bands));
  if (high_ > low_) bands_a_metre_ = static_cast<double>(bands_.size()) / (high_ - low_);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Segment edge = polygon.edge(i);
    const auto [below, above] = std::minmax({edge.a.y(), edge.b.y()});
    for (std::size_t k = band(below); k <= band(above); ++k) bands_[k].push_back(edge);
  }
}

bool Inside::contains(const Vec2& point) const {
  if (!(point.y() >= low_ && point.y() <= high_)) return false;
  bool inside = false;
  for (const Segment& edge : bands_[band(point.y())])
    if (passes_right_of(point, edge.a, edge.b)) inside = !inside;
  return inside;
}

// Grows with y, so the band of a height is among those of each edge that passes it.
std::size_t Inside::band(double y) const {
  return std::min(static_cast<std::size_t>((y - low_) * bands_a_metre_), bands_.size() - 1);
}

}  // namespace roomgen
