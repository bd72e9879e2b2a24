#pragma once

#include "roomgen/create/description.h"
#include "roomgen/shape/program.h"

namespace roomgen::create {

/// A thing of no known kind, from its parts alone: what carries at the bottom, what is used in the
/// middle, what rises above it at the back, the rest on top. `size` is its box.
shape::Program assemble(const Description& description, const Vec3& size);

/// The part as it would be on a thing of this box, whose `top` is where things stand on it: wheels
/// below, a back behind, a lamp on top. False if nothing is known about such a part.
bool attach(shape::Program& program, const PartWish& part, const Bounds3& box, double top);

}  // namespace roomgen::create
