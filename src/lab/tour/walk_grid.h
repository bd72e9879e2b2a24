#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "free_space.h"

namespace roomgen::lab::detail {

using GridNode = std::uint32_t;

/// The shortest ways from one node to all that can be walked to (Dijkstra).
struct ShortestWays {
  std::vector<double> metres;  ///< infinity where nobody gets
  std::vector<GridNode> before;

  bool reach(GridNode node) const { return metres[node] < std::numeric_limits<double>::infinity(); }
  /// Both ends included.
  std::vector<GridNode> to(GridNode node) const;
};

/// Places to stand, and steps to the eight neighbours of each; every step is free from end to end. Places are 5 cm
/// apart, or as many whole centimetres as leave about a million of them (beyond 50 x 50 m).
class WalkGrid {
 public:
  explicit WalkGrid(const FreeSpace& space);

  double pitch() const { return pitch_; }
  std::size_t size() const { return clearance_.size(); }
  Vec2 place(GridNode node) const;
  bool can_stand(GridNode node) const { return clearance_[node] >= least_clearance_; }
  ShortestWays ways_from(GridNode start) const;

 private:
  struct Step {
    int columns, rows;
    double metres;
  };
  bool is_free(GridNode from, GridNode to, double metres) const;
  void find_steps();

  const FreeSpace* space_;
  double pitch_;
  std::vector<Step> steps_;  ///< a step and its reverse are four apart
  Vec2 low_;
  int columns_ = 0, rows_ = 0;
  double least_clearance_ = 0.0;
  std::vector<double> clearance_;
  std::vector<std::uint8_t> open_;  ///< bit k: steps_[k] is free
};

/// The same way with fewer corners: each part is the longest straight line that stays free.
std::vector<Vec2> pulled_straight(const FreeSpace& space, const std::vector<Vec2>& way);

double length_of(const std::vector<Vec2>& way);

}  // namespace roomgen::lab::detail
