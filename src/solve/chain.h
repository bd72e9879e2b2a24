#pragma once

#include <vector>

#include "base/random.h"
#include "ensemble.h"

namespace roomgen {

/// Where a chain is: equal states go on equally.
struct ChainState {
  Poses poses;
  Poses local = {};  ///< in the frames of the anchors; the pose itself of what has none. Found out at first
  Random random{0};
};

/// A Markov chain on whole layouts. A step puts one thing at a pose drawn from its domain, which takes along what
/// is placed by it. What depends on it and can neither go along nor stay, and what is in its way, is put at a pose
/// drawn from its own domain. The step is taken if all constraints hold and nothing invalid stands in the end.
class Chain {
 public:
  /// All must outlive this; the ensemble stands as the state says from now on.
  Chain(std::span<const Movable> movables, Ensemble& ensemble, ChainState& state);

  /// Is everything right where the chain stands? Steps lead from such layouts to such layouts alone.
  bool stands();
  /// True if it was taken.
  bool step();
  /// The layout as it stands; the state is brought up to date.
  const Poses& poses();

 private:
  bool lead(std::size_t leader);
  bool takes_along(std::size_t leader);
  bool followers_find_places(std::size_t leader);
  bool finds_place(std::size_t follower);
  bool settles(std::size_t i);
  void put_local(std::size_t i, const Pose& local);
  const Pose& draw(std::size_t i);
  void remember(std::size_t i);
  void undo();

  std::span<const Movable> movables_;
  Ensemble& ensemble_;
  ChainState& state_;
  std::vector<std::size_t> free_;   ///< things that have a domain
  std::vector<bool> loose_;         ///< whose place is not yet known in this step
  std::vector<std::size_t> followers_;  ///< that need a place in this step, in placement order
  std::vector<std::size_t> moved_;      ///< in this step
  Poses local_before_;              ///< parallel to moved_
};

}  // namespace roomgen
