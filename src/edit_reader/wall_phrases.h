#pragma once

#include "destinations.h"

namespace roomgen {

/// A wall that words name, and where on it.
struct NamedWall {
  std::size_t wall = 0;
  std::optional<double> at;
  std::size_t end = 0;
};

/// "in the left wall", "the wall behind the sofa"
std::optional<NamedWall> wall_at(const EditText& text, std::size_t at);
/// "behind the sink", "opposite the door", "with the window", after "the wall"; `may_be_near`: "by the bed" too.
std::optional<NamedWall> wall_by_target(const EditText& text, std::size_t at, bool may_be_near);
/// The one that looks at it.
std::size_t wall_opposite(const Room& room, std::size_t wall);

}  // namespace roomgen
