#pragma once

#include <optional>

#include "roomgen/scene/problem.h"
#include "layout.h"

namespace roomgen {

/// Flush things stand this far off, metres, so that faces do not coincide and rounding pushes nothing into a
/// wall.
inline constexpr double flush = 0.004;

/// Where a task wants its object as things stand now: along with what carries it, and flush with the walls
/// that it nearly touches.
struct Suggestion {
  std::optional<Vec2> location;
  std::optional<double> facing;
  bool binds = false;  ///< it is somebody's word, which everything else but constraints gives way to
};
Suggestion suggestion_of(const Layout& layout, const PlacementTask& task);

/// The angle between a yaw and the one that is wanted, radians in [0, pi]: what has no front looks the
/// same from several sides.
double turn_between(const Object& object, double yaw, double wanted);

/// Does a pose do as suggested, 0.10 m and 5 degrees aside?
bool follows(const Object& object, const Pose& pose, const Suggestion& suggestion);

}  // namespace roomgen
