#include "occupancy_grid.h"

#include <algorithm>
#include <cmath>

#include "geometry/inside.h"

namespace roomgen {

namespace {

// Cells lie within this margin of what they stand for, so that a gap of exactly 0.5 m is passable.
constexpr double slack = 1e-6;
constexpr int word_bits = 64;

// Spreads the bits of `seeds` over runs of `open` bits, both ways (Kogge-Stone parallel prefix).
std::uint64_t fill_runs(std::uint64_t seeds, std::uint64_t open) {
  std::uint64_t up = seeds & open, down = up, open_up = open, open_down = open;
  for (int shift = 1; shift < word_bits; shift *= 2) {
    up |= open_up & (up << shift);
    open_up &= open_up << shift;
    down |= open_down & (down >> shift);
    open_down &= open_down >> shift;
  }
  return up | down;
}

}  // namespace

OccupancyGrid::OccupancyGrid(const Room& room, double pitch) : pitch_(pitch) {
  const Bounds2 box = bounds(room.polygon);
  low_ = box.low;
  columns_ = std::max(1, static_cast<int>(std::ceil(box.size().x() / pitch_)));
  rows_ = std::max(1, static_cast<int>(std::ceil(box.size().y() / pitch_)));
  words_ = (columns_ + word_bits - 1) / word_bits;
  blocked_.resize(static_cast<std::size_t>(columns_) * rows_);
  free_.resize(static_cast<std::size_t>(words_) * rows_);
  reachable_.resize(free_.size());
  std::fill(blocked_.begin(), blocked_.end(), std::uint16_t{1});
  for (int r = 0; r < rows_; ++r) open_inside(room.polygon, r);
  for (std::size_t k = 0; k < room.polygon.size(); ++k) block_along(room.polygon.edge(k));
  for (const auto& opening : room.openings)
    if (opening.is_entrance()) doors_.push_back(cells_in(door_clearance(room, opening)));
}

// The crossings of the walls with a row part it into what is inside and what is not.
void OccupancyGrid::open_inside(const Polygon& polygon, int row) {
  const double y = center(0, row).y();
  std::vector<double> crossings;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    if (const Segment wall = polygon.edge(k); crosses_height(y, wall.a, wall.b)) crossings.push_back(crossing(y, wall.a, wall.b));
  std::sort(crossings.begin(), crossings.end());
  std::size_t passed = 0;
  for (int c = 0; c < columns_; ++c) {
    while (passed < crossings.size() && crossings[passed] <= center(c, row).x()) ++passed;
    if (passed % 2 == 1) change_count(c, row, -1);
  }
}

// Only cells beside that part of the wall that comes near enough to their row are measured.
void OccupancyGrid::block_along(const Segment& wall) {
  const auto [low, high] = std::minmax({wall.a.y(), wall.b.y()});
  for (int r = row(low - person_radius); r <= row(high + person_radius); ++r) {
    const double y = center(0, r).y();
    const auto at = [&](double height) {
      const double along = (std::clamp(height, low, high) - wall.a.y()) / (wall.b.y() - wall.a.y());
      return wall.a.x() + along * (wall.b.x() - wall.a.x());
    };
    const bool is_level = high - low < slack;
    const auto [left, right] = is_level ? std::minmax({wall.a.x(), wall.b.x()})
                                        : std::minmax({at(y - person_radius), at(y + person_radius)});
    for (int c = column(left - person_radius - slack); c <= column(right + person_radius + slack); ++c)
      if (is_free(c, r) && distance(wall, center(c, r)) < person_radius - slack) change_count(c, r, +1);
  }
}

int OccupancyGrid::column(double x) const {
  return std::clamp(static_cast<int>(std::floor((x - low_.x()) / pitch_)), 0, columns_ - 1);
}

int OccupancyGrid::row(double y) const {
  return std::clamp(static_cast<int>(std::floor((y - low_.y()) / pitch_)), 0, rows_ - 1);
}

Vec2 OccupancyGrid::center(int column, int row) const {
  return low_ + pitch_ * Vec2(column + 0.5, row + 0.5);
}

bool OccupancyGrid::is_free(int column, int row) const {
  return blocked_[static_cast<std::size_t>(row) * columns_ + column] == 0;
}

bool OccupancyGrid::is_reachable(int column, int row) const {
  return reachable_[static_cast<std::size_t>(row) * words_ + column / word_bits] >>
             (column % word_bits) & 1u;
}

void OccupancyGrid::change_count(int column, int row, int change) {
  auto& count = blocked_[static_cast<std::size_t>(row) * columns_ + column];
  count = static_cast<std::uint16_t>(count + change);
  auto& word = free_[static_cast<std::size_t>(row) * words_ + column / word_bits];
  const std::uint64_t bit = std::uint64_t{1} << (column % word_bits);
  word = count == 0 ? word | bit : word & ~bit;
}

void OccupancyGrid::stamp(const Footprint& footprint, int change) {
  const Vec2 reach = Vec2::Constant(person_radius);
  const Vec2 low = footprint.bounds().low - reach, high = footprint.bounds().high + reach;
  const double limit = person_radius - slack;
  const double inner = footprint.half().minCoeff() - slack, outer = 1.01 * footprint.half().maxCoeff();
  const int first = column(low.x()), last = column(high.x());
  for (int r = row(low.y()); r <= row(high.y()); ++r) {
    if (footprint.round()) {
      for (int c = first; c <= last; ++c) {
        // Its outline lies between two circles: only what is between both is measured.
        const double away = (center(c, r) - footprint.center()).norm();
        if (away >= outer + limit) continue;
        if (away < inner + limit || gap(footprint, center(c, r)) < limit) change_count(c, r, change);
      }
      continue;
    }
    // The local coordinates change by a constant from cell to cell.
    Vec2 local = footprint.to_local(center(first, r));
    const Vec2 step = footprint.to_local(center(first + 1, r)) - local;
    for (int c = first; c <= last; ++c, local += step) {
      const double dx = std::max(0.0, std::abs(local.x()) - footprint.half().x());
      const double dy = std::max(0.0, std::abs(local.y()) - footprint.half().y());
      if (dx * dx + dy * dy < limit * limit) change_count(c, r, change);
    }
  }
}

std::vector<OccupancyGrid::Cell> OccupancyGrid::cells_in(const Footprint& area) const {
  std::vector<Cell> cells;
  for (int r = row(area.bounds().low.y()); r <= row(area.bounds().high.y()); ++r)
    for (int c = column(area.bounds().low.x()); c <= column(area.bounds().high.x()); ++c)
      if (contains(area, center(c, r))) cells.push_back({c, r});
  return cells;
}

// Lets the reachable cells of `from_row` into `row` and spreads them along it; true if any was new.
bool OccupancyGrid::flood_row(int row, int from_row) {
  auto* own = reachable_.data() + static_cast<std::size_t>(row) * words_;
  const auto* from = reachable_.data() + static_cast<std::size_t>(from_row) * words_;
  const auto* open = free_.data() + static_cast<std::size_t>(row) * words_;
  bool changed = false;
  const auto spread = [&](int w, std::uint64_t seeds) {
    const std::uint64_t filled = fill_runs(own[w] | seeds, open[w]);
    changed = changed || filled != own[w];
    own[w] = filled;
  };
  for (int w = 0; w < words_; ++w)
    spread(w, from[w] | (w > 0 ? own[w - 1] >> (word_bits - 1) : 0));
  for (int w = words_ - 2; w >= 0; --w) spread(w, own[w + 1] << (word_bits - 1));
  return changed;
}

void OccupancyGrid::flood() {
  if (doors_.empty()) {
    reachable_ = free_;
    return;
  }
  std::fill(reachable_.begin(), reachable_.end(), std::uint64_t{0});
  for (const auto& cell : doors_.front())
    reachable_[static_cast<std::size_t>(cell.row) * words_ + cell.column / word_bits] |=
        std::uint64_t{1} << (cell.column % word_bits);
  for (std::size_t w = 0; w < free_.size(); ++w) reachable_[w] &= free_[w];
  bool changed = true;
  while (changed) {
    changed = false;
    for (int r = 0; r < rows_; ++r) changed = flood_row(r, std::max(r - 1, 0)) || changed;
    for (int r = rows_ - 2; r >= 0; --r) changed = flood_row(r, r + 1) || changed;
  }
}

bool OccupancyGrid::doors_connected() const {
  return std::all_of(doors_.begin(), doors_.end(), [this](const std::vector<Cell>& cells) {
    return std::any_of(cells.begin(), cells.end(),
                       [this](const Cell& cell) { return is_reachable(cell.column, cell.row); });
  });
}

bool OccupancyGrid::reaches(const Footprint& zone) const {
  const Vec2 reach = Vec2::Constant(person_radius);
  const Vec2 low = zone.bounds().low - reach, high = zone.bounds().high + reach;
  for (int r = row(low.y()); r <= row(high.y()); ++r)
    for (int c = column(low.x()); c <= column(high.x()); ++c)
      if (is_reachable(c, r) && gap(zone, center(c, r)) <= person_radius) return true;
  return false;
}

}  // namespace roomgen
