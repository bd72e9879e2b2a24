#pragma once

#include <cstddef>
#include <string>

#include "roomgen/base/result.h"
#include "roomgen/scene/room.h"

namespace roomgen {

/// "wall-2"
std::string wall_name(std::size_t wall);
/// Its number; not_found, naming the walls that there are.
Result<std::size_t> wall_named(const Room& room, const std::string& name);

}  // namespace roomgen
