#pragma once

#include <functional>
#include <vector>

#include "composition/arrange.h"
#include "place.h"

namespace roomgen {

/// The real thing that a member of a group is; null if there is none. Position and yaw mean nothing
/// but its height.
using ThingOf = std::function<const Object*(const composition::Member&)>;

/// The members of a group that are placed together with its anchor: all but what stands on others,
/// and what is no thing. Appends the index of each in `arranged`.
std::vector<PlacementTask::Companion> companions(const composition::Arranged& arranged,
                                                 const ThingOf& thing_of, const Room& room,
                                                 std::vector<std::size_t>& members);

/// Where the anchor of a group stands, in which of the ways, and the task that put it there.
struct PlacedGroup {
  std::size_t way = 0;
  Placement placement;
  PlacementTask task;
};

struct WaysToPlace {
  std::span<const composition::Arranged> ways;
  const ThingOf& thing_of;
};

/// Places a group as one thing: in the first way in which nothing that was asked for is lost, else
/// in the one that loses least. Fails as place() does in the first way where there is none.
Result<PlacedGroup> place_group(Layout& layout, const PlacementTask& anchor,
                                const WaysToPlace& group, const PlaceOptions& options,
                                Random& random);

}  // namespace roomgen
