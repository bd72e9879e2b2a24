#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "free_space.h"

namespace roomgen::detail {

using GridNode = std::uint32_t;

/// The shortest ways from one node to all that can be walked to (Dijkstra).
struct ShortestWays {
  std::vector<double> metres;  ///< infinity where nobody gets
  std::vector<GridNode> before;

  bool reach(GridNode node) const { return metres[node] < std::numeric_limits<double>::infinity(); }
  /// Both ends included.
  std::vector<GridNode> to(GridNode node) const;
};

/// Places to stand, and steps to the eight neighbours of each; every step is free from end to end.
class WalkGrid {
 public:
  static constexpr double pitch = 0.05;

  explicit WalkGrid(const FreeSpace& space);

  std::size_t size() const { return clearance_.size(); }
  Vec2 place(GridNode node) const;
  bool can_stand(GridNode node) const { return clearance_[node] >= least_clearance_; }
  ShortestWays ways_from(GridNode start) const;

 private:
  struct Step {
    int columns, rows;
    double metres;
  };
  static const std::vector<Step>& steps();
  bool is_free(GridNode from, GridNode to, double metres) const;
  void find_steps();

  const FreeSpace* space_;
  Vec2 low_;
  int columns_ = 0, rows_ = 0;
  double least_clearance_ = 0.0;
  std::vector<double> clearance_;
  std::vector<std::uint8_t> open_;  ///< bit k: steps()[k] is free
};

/// The same way with fewer corners: each part is the longest straight line that stays free.
std::vector<Vec2> pulled_straight(const FreeSpace& space, const std::vector<Vec2>& way);

double length_of(const std::vector<Vec2>& way);

}  // namespace roomgen::detail
