#pragma once

#include <span>
#include <string>
#include <vector>

#include "collision/support_poses.h"
#include "workplace.h"

namespace roomgen {

/// A thing that the plan puts onto another, as a box a little smaller than planned.
struct Load {
  Object object;
  bool inside = false;  ///< below the top of what carries it
};

/// What the plan puts onto the thing of this id, itself or by its groups.
std::vector<Load> loads_on(const std::string& id, const Workplace& place);

/// Whether each of the loads finds a place, were the others not there.
bool can_carry(const Object& carrier, std::span<const Load> loads, const SupportPoses& poses);

}  // namespace roomgen
