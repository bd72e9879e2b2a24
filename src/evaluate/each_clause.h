#pragma once

#include <functional>
#include <span>
#include <string>

#include "roomgen/scene/object.h"
#include "roomgen/scene/room.h"

namespace roomgen {

/// Why not every owner has `count` of the things that are its own, each thing being one owner's at most; empty if
/// every one has. `belongs` tells whether a thing is where the owner's would be.
std::string each_fault(std::span<const Object* const> things, std::span<const std::string> owners, int count,
                       const std::function<bool(const Object&, const std::string&)>& belongs);

/// Why not every corner of a room has `count` of the things; a thing that is in a corner is in the nearest.
std::string corners_fault(std::span<const Object* const> things, const Room& room, int count,
                          const std::function<bool(const Object&)>& is_in_corner);

}  // namespace roomgen
