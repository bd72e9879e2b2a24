#pragma once

#include "roomgen/geometry/model.h"

namespace roomgen {

enum class Outline { round, oval, square, rectangular, l_shaped, other };
std::string_view name(Outline outline);

/// What a mesh looks like along an axis (0 to 2), from its shadow on a grid: round or oval when it fills the
/// ellipse in its box and leaves the corners, square or rectangular when it fills the box, L-shaped when
/// just one corner is empty. Sides that differ by less than a seventh count as equal.
Outline outline_along(const Mesh& mesh, int axis);

/// Of what lies or stands (from above), hangs on a wall, or is flat: along its thinnest side, if that is
/// less than a third of the others, else from above.
Outline outline_of(const Mesh& mesh);

}  // namespace roomgen
