#include "roomgen/collision/walk_map.h"

#include <algorithm>
#include <cmath>

namespace roomgen {

namespace {
// Cells lie within this margin of what they stand for, so that a gap of exactly 0.5 m is passable.
constexpr double slack = 1e-6;
}  // namespace

WalkMap::WalkMap(const Room& room, double pitch) : pitch_(pitch) {
  const Bounds2 box = bounds(room.polygon);
  low_ = box.low;
  columns_ = std::max(1, static_cast<int>(std::ceil(box.size().x() / pitch_)));
  rows_ = std::max(1, static_cast<int>(std::ceil(box.size().y() / pitch_)));
  const auto cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  blocked_.resize(cells);
  reachable_.resize(cells);
  for (int r = 0; r < rows_; ++r)
    for (int c = 0; c < columns_; ++c) {
      const Vec2 point = center(c, r);
      const bool free = contains(room.polygon, point) &&
                        distance_to_boundary(room.polygon, point) >= person_radius - slack;
      blocked_[static_cast<std::size_t>(r) * columns_ + c] = free ? 0 : 1;
    }
  for (const auto& opening : room.openings)
    if (opening.is_entrance()) doors_.push_back(cells_in(door_clearance(room, opening)));
}

int WalkMap::column(double x) const {
  return std::clamp(static_cast<int>(std::floor((x - low_.x()) / pitch_)), 0, columns_ - 1);
}

int WalkMap::row(double y) const {
  return std::clamp(static_cast<int>(std::floor((y - low_.y()) / pitch_)), 0, rows_ - 1);
}

Vec2 WalkMap::center(int column, int row) const {
  return low_ + pitch_ * Vec2(column + 0.5, row + 0.5);
}

void WalkMap::stamp(const Footprint& footprint, int change) {
  const Vec2 reach = Vec2::Constant(person_radius);
  const Vec2 low = footprint.bounds().low - reach, high = footprint.bounds().high + reach;
  for (int r = row(low.y()); r <= row(high.y()); ++r)
    for (int c = column(low.x()); c <= column(high.x()); ++c)
      if (gap(footprint, center(c, r)) < person_radius - slack) {
        auto& count = blocked_[static_cast<std::size_t>(r) * columns_ + c];
        count = static_cast<std::uint16_t>(count + change);
      }
}

std::vector<int> WalkMap::cells_in(const Footprint& area) const {
  std::vector<int> cells;
  for (int r = row(area.bounds().low.y()); r <= row(area.bounds().high.y()); ++r)
    for (int c = column(area.bounds().low.x()); c <= column(area.bounds().high.x()); ++c)
      if (contains(area, center(c, r))) cells.push_back(r * columns_ + c);
  return cells;
}

void WalkMap::flood() {
  if (doors_.empty()) {
    for (std::size_t i = 0; i < blocked_.size(); ++i) reachable_[i] = blocked_[i] == 0;
    return;
  }
  std::fill(reachable_.begin(), reachable_.end(), std::uint8_t{0});
  frontier_.clear();
  const auto visit = [this](int cell) {
    if (blocked_[cell] == 0 && !reachable_[cell]) {
      reachable_[cell] = 1;
      frontier_.push_back(cell);
    }
  };
  for (int cell : doors_.front()) visit(cell);
  while (!frontier_.empty()) {
    const int cell = frontier_.back();
    frontier_.pop_back();
    const int c = cell % columns_;
    if (c > 0) visit(cell - 1);
    if (c + 1 < columns_) visit(cell + 1);
    if (cell >= columns_) visit(cell - columns_);
    if (cell + columns_ < static_cast<int>(blocked_.size())) visit(cell + columns_);
  }
}

bool WalkMap::doors_connected() const {
  return std::all_of(doors_.begin(), doors_.end(), [this](const std::vector<int>& cells) {
    return std::any_of(cells.begin(), cells.end(), [this](int cell) { return reachable_[cell]; });
  });
}

bool WalkMap::reaches(const Footprint& zone) const {
  const Vec2 reach = Vec2::Constant(person_radius);
  const Vec2 low = zone.bounds().low - reach, high = zone.bounds().high + reach;
  for (int r = row(low.y()); r <= row(high.y()); ++r)
    for (int c = column(low.x()); c <= column(high.x()); ++c)
      if (reachable_[static_cast<std::size_t>(r) * columns_ + c] &&
          gap(zone, center(c, r)) <= person_radius)
        return true;
  return false;
}

}  // namespace roomgen
