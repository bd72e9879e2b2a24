#include "walk_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "roomgen/base/json.h"

namespace roomgen::lab::detail {

namespace {

constexpr double clearance_of_interest = 0.2;  // beyond the radius: more tells nothing of single steps
constexpr double grid_rounding = 1e-6;
constexpr double finest_pitch = 0.05;
constexpr double most_places = 1e6;  // the ways to all of them are sought once for each target
constexpr double centimetre = 0.01;

double pitch_over(const Vec2& size) {
  const double wanted = std::sqrt(size.prod() / most_places);
  return wanted <= finest_pitch ? finest_pitch : std::ceil(wanted / centimetre) * centimetre;
}

}  // namespace

WalkGrid::WalkGrid(const FreeSpace& space)
    : space_(&space), pitch_(pitch_over(space.extent().size())), least_clearance_(space.radius() - grid_rounding) {
  const double across = std::numbers::sqrt2 * pitch_;
  steps_ = {{1, 0, pitch_},  {1, 1, across},   {0, 1, pitch_},  {-1, 1, across},
            {-1, 0, pitch_}, {-1, -1, across}, {0, -1, pitch_}, {1, -1, across}};
  // Places are as files hold them.
  low_ = {rounded(space.extent().low.x()), rounded(space.extent().low.y())};
  const Vec2 size = space.extent().size();
  columns_ = static_cast<int>(std::floor(size.x() / pitch_)) + 1;
  rows_ = static_cast<int>(std::floor(size.y() / pitch_)) + 1;
  clearance_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (GridNode node = 0; node < clearance_.size(); ++node)
    clearance_[node] = space.clearance(place(node), space.radius() + clearance_of_interest);
  find_steps();
}

Vec2 WalkGrid::place(GridNode node) const {
  const int column = static_cast<int>(node) % columns_, row = static_cast<int>(node) / columns_;
  return low_ + pitch_ * Vec2(column, row);
}

// No clearance changes faster than one moves: only steps that pass close to something are measured.
bool WalkGrid::is_free(GridNode from, GridNode to, double metres) const {
  if (!can_stand(from) || !can_stand(to)) return false;
  return clearance_[from] + clearance_[to] >= 2.0 * space_->radius() + metres ||
         space_->is_free({place(from), place(to)});
}

void WalkGrid::find_steps() {
  open_.resize(clearance_.size());
  for (GridNode node = 0; node < open_.size(); ++node) {
    const int column = static_cast<int>(node) % columns_, row = static_cast<int>(node) / columns_;
    for (std::size_t k = 0; k < 4; ++k) {
      const int c = column + steps_[k].columns, r = row + steps_[k].rows;
      if (c < 0 || c >= columns_ || r >= rows_) continue;
      const auto next = static_cast<GridNode>(r * columns_ + c);
      if (!is_free(node, next, steps_[k].metres)) continue;
      open_[node] = static_cast<std::uint8_t>(open_[node] | 1u << k);
      open_[next] = static_cast<std::uint8_t>(open_[next] | 1u << (k + 4));
    }
  }
}

ShortestWays WalkGrid::ways_from(GridNode start) const {
  ShortestWays ways;
  ways.metres.assign(size(), std::numeric_limits<double>::infinity());
  ways.before.assign(size(), start);
  using Entry = std::pair<double, GridNode>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  ways.metres[start] = 0.0;
  queue.emplace(0.0, start);
  while (!queue.empty()) {
    const auto [metres, node] = queue.top();
    queue.pop();
    if (metres > ways.metres[node]) continue;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      if (!(open_[node] >> k & 1u)) continue;
      const auto next = static_cast<GridNode>(static_cast<int>(node) + steps_[k].rows * columns_ + steps_[k].columns);
      const double there = metres + steps_[k].metres;
      if (there >= ways.metres[next]) continue;
      ways.metres[next] = there;
      ways.before[next] = node;
      queue.emplace(there, next);
    }
  }
  return ways;
}

std::vector<GridNode> ShortestWays::to(GridNode node) const {
  std::vector<GridNode> nodes = {node};
  while (before[nodes.back()] != nodes.back()) nodes.push_back(before[nodes.back()]);
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

std::vector<Vec2> pulled_straight(const FreeSpace& space, const std::vector<Vec2>& way) {
  std::vector<Vec2> corners = {way.front()};
  for (std::size_t at = 0; at + 1 < way.size();) {
    std::size_t next = way.size() - 1;
    while (next > at + 1 && !space.is_free({way[at], way[next]})) --next;
    corners.push_back(way[next]);
    at = next;
  }
  return corners;
}

double length_of(const std::vector<Vec2>& way) {
  double sum = 0.0;
  for (std::size_t k = 1; k < way.size(); ++k) sum += (way[k] - way[k - 1]).norm();
  return sum;
}

}  // namespace roomgen::lab::detail
