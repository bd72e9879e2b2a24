#pragma once

#include <span>
#include <vector>

#include "layout.h"
#include "roomgen/scene/problem.h"
#include "scene/judgement.h"

namespace roomgen {

/// What a layout is worth: first how many things that were asked for found a place, then how many of
/// the wishes hold, then how many things there are at all, then how little of what binds was moved, then
/// how many constraints hold, then how well.
struct LayoutQuality {
  int asked = 0;
  int wishes = 0;
  int placed = 0;
  double displaced = 0.0;  ///< metres in all, those of earlier things weighing up to twice as much
  int held = 0;
  double degree = 0.0;

  bool better_than(const LayoutQuality& other) const;
  /// The same or more of everything that is counted; the degree may be worse.
  bool as_good_as(const LayoutQuality& other) const;
};
LayoutQuality quality(const Layout& layout, const std::vector<PlacementTask>& tasks);

/// How many of the relations hold for an object at its pose.
int count_held(std::span<const ResolvedRelation> relations, const Object& object, const Room& room);

}  // namespace roomgen
