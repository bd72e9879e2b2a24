#include <algorithm>
#include <cmath>
#include <vector>

#include "physics.h"
#include "roomgen/geometry/polygon.h"

namespace roomgen::lab::sceneeval {

namespace {

constexpr int half_cells = 128;
constexpr int cells = 2 * half_cells;
constexpr double robot_width = 0.2;
constexpr double margin = 0.2;
constexpr double highest_middle = 2.0;

// The floor's square map: row 0 is the far end (+y).
class FloorMap {
 public:
  explicit FloorMap(const Room& room) : free_(cells * cells) {
    const Bounds2 box = bounds(room.polygon);
    middle_ = 0.5 * (box.low + box.high);
    scale_ = 0.5 * box.size().maxCoeff() + margin;
    // Whole cells, as the map of a picture has it.
    clearance_ = 0.5 * std::floor(robot_width / scale_ * half_cells) * scale_ / half_cells;
    for (int row = 0; row < cells; ++row)
      for (int column = 0; column < cells; ++column) {
        const Vec2 place = center(column, row);
        at(column, row) = contains(room.polygon, place) &&
                          distance_to_boundary_square(room.polygon, place) >= clearance_;
      }
  }

  void block(const Footprint& footprint) {
    for (int row = 0; row < cells; ++row)
      for (int column = 0; column < cells; ++column)
        if (at(column, row) && gap(footprint, center(column, row)) <= clearance_)
          at(column, row) = false;
  }

  double largest_share() const {
    std::size_t all = 0, largest = 0;
    std::vector<char> seen(free_.size());
    for (int start = 0; start < cells * cells; ++start) {
      if (!free_[static_cast<std::size_t>(start)] || seen[static_cast<std::size_t>(start)]) continue;
      const std::size_t size = flood(start, seen);
      all += size;
      largest = std::max(largest, size);
    }
    return all == 0 ? 0.0 : static_cast<double>(largest) / static_cast<double>(all);
  }

 private:
  char& at(int column, int row) { return free_[static_cast<std::size_t>(row * cells + column)]; }

  Vec2 center(int column, int row) const {
    return middle_ + scale_ / half_cells * Vec2(column - half_cells, half_cells - row);
  }

  // The kernel that shrinks the floor is a square: the longer way of x and y counts.
  static double distance_to_boundary_square(const Polygon& polygon, const Vec2& place) {
    double least = 1e300;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Segment edge = polygon.edge(k);
      const Vec2 along = edge.b - edge.a;
      // The nearest point in that measure is at an end, at the foot of an axis, or on a diagonal.
      const auto consider = [&](double t) {
        const Vec2 p = edge.a + std::clamp(t, 0.0, 1.0) * along - place;
        least = std::min(least, p.cwiseAbs().maxCoeff());
      };
      consider(0.0), consider(1.0);
      const Vec2 from = place - edge.a;
      for (const double sign : {1.0, -1.0}) {
        const double slope = along.x() - sign * along.y();
        if (std::abs(slope) > 1e-12) consider((from.x() - sign * from.y()) / slope);
      }
      for (int axis = 0; axis < 2; ++axis)
        if (std::abs(along[axis]) > 1e-12) consider(from[axis] / along[axis]);
    }
    return least;
  }

  std::size_t flood(int start, std::vector<char>& seen) const {
    std::vector<int> open = {start};
    seen[static_cast<std::size_t>(start)] = 1;
    std::size_t size = 0;
    while (!open.empty()) {
      const int cell = open.back();
      open.pop_back();
      ++size;
      const int row = cell / cells, column = cell % cells;
      for (int r = std::max(0, row - 1); r <= std::min(cells - 1, row + 1); ++r)
        for (int c = std::max(0, column - 1); c <= std::min(cells - 1, column + 1); ++c) {
          const auto next = static_cast<std::size_t>(r * cells + c);
          if (!free_[next] || seen[next]) continue;
          seen[next] = 1;
          open.push_back(r * cells + c);
        }
    }
    return size;
  }

  std::vector<char> free_;
  Vec2 middle_ = Vec2::Zero();
  double scale_ = 1.0;      ///< metres of half the map
  double clearance_ = 0.0;  ///< metres
};

}  // namespace

double navigability(std::span<const OrientedBox> boxes, const Room& room) {
  FloorMap map(room);
  for (const auto& box : boxes)
    if (box.center.z() <= highest_middle)
      map.block(Footprint(box.center.head<2>(), 2.0 * box.half.head<2>(), box.yaw));
  return map.largest_share();
}

}  // namespace roomgen::lab::sceneeval
