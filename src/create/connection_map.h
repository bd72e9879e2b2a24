#pragma once

#include <string>
#include <vector>

#include "assembly.h"
#include "validate.h"

namespace roomgen::create::detail {

/// Parts that shall touch: one of the first with one of the second, or with the floor.
struct Link {
  std::vector<std::size_t> one, other;
  bool floor = false;
  /// Declared, or feet that must stand: it is wrong when open. Others only say where a part belongs
  /// that is joined to nothing.
  bool firm = false;
  std::string text;  ///< "leg-2 and seat"
};

/// The program's connections, each copy by itself, and those that labels suggest. A pair of groups
/// is linked when anything in the one touches anything in the other.
std::vector<Link> connection_map(const Assembly& assembly, Footing footing);

}  // namespace roomgen::create::detail
