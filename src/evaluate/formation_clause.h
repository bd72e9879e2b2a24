#pragma once

#include <span>
#include <string>

#include "roomgen/scene/object.h"

namespace roomgen {

/// Why things do not stand in so many straight rows (0: however many there are, at least two), as many in each, or
/// fewer in one of them; empty if they do. A row's centres lie within 0.15 m of a line along a side of the first
/// thing, none farther than 2.5 m from the next.
std::string rows_fault(std::span<const Object* const> things, int rows);

/// Why things (three or more) do not stand in a circle, empty if they do: their centres within 0.25 m of it (the best by
/// least squares), and no gap between neighbours wider than 1.6 times the even one.
std::string circle_fault(std::span<const Object* const> things);

/// Why things (three or more) do not stand in an arc, empty if they do: their centres within 0.25 m of a circle, of which
/// they span from 80 to 300 degrees, no gap between neighbours within it twice as wide as the even one.
std::string arc_fault(std::span<const Object* const> things);

/// Why things do not stand in islands of so many, empty if they do: those of one are at most 0.12 m apart, those of
/// different ones farther; what is left over when they are dealt out may make a smaller one.
std::string islands_fault(std::span<const Object* const> things, int size);

}  // namespace roomgen
