#pragma once

#include <span>
#include <string>

#include "roomgen/scene/object.h"

namespace roomgen {

/// Why things do not stand in so many straight rows (0: however many there are, at least two), as many in each, or
/// fewer in one of them; empty if they do. A row's centres lie within 0.15 m of a line along a side of the first
/// thing, none farther than 2.5 m from the next.
std::string rows_fault(std::span<const Object* const> things, int rows);

}  // namespace roomgen
