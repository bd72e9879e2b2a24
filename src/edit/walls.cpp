#include "walls.h"

namespace roomgen {

std::string wall_name(std::size_t wall) { return "wall-" + std::to_string(wall); }

Result<std::size_t> wall_named(const Room& room, const std::string& name) {
  const std::size_t count = room.polygon.size();
  for (std::size_t k = 0; k < count; ++k)
    if (name == wall_name(k)) return k;
  return Error{Error::Kind::not_found,
               "there is no \"" + name + "\": the room has " + wall_name(0) + " to " + wall_name(count - 1)};
}

}  // namespace roomgen
