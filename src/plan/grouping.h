#pragma once

#include <string>
#include <vector>

#include "fitting.h"
#include "solve/arrangement.h"

namespace roomgen::plan {

/// Finds which of a room's things belong together (data/compositions), so that they are placed as
/// one. Remembers what compositions hold: one serves all attempts at a plan.
class Grouping {
 public:
  Grouping(const KindTable& kinds, const Arrangements& arrangements);

  /// The floor that they take when they are grouped: of each group that of its box.
  struct Floor {
    double area = 0.0;            ///< square metres
    Vec2 largest = Vec2::Zero();  ///< the box of the largest group, with a way
  };
  Floor floor_of(std::vector<Draft> drafts, const brief::Brief& brief);

  /// Groups the drafts anew: those that gain most first. Drafts whose things go to several groups
  /// are split. What is told of a thing's place beyond being at its anchor keeps it out. What is told
  /// to stand in rows, in a circle or an arc, and many of what usually stands in rows, becomes a
  /// block, with what belongs to each; in a room it is told where it stands.
  void run(std::vector<Draft>& drafts, const brief::Brief& brief, Plan& plan);
  /// The same with the drafts that are in no group and have no place, besides the plan's groups.
  void gather(std::vector<Draft>& drafts, const brief::Brief& brief, Plan& plan);

 private:
  const KindTable& kinds_;
  const Arrangements& arrangements_;
  Fitting fitting_;
};

}  // namespace roomgen::plan
