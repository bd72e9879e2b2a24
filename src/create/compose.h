#pragma once

#include <vector>

#include "roomgen/create/maker.h"
#include "roomgen/shape/program.h"

namespace roomgen::create {

/// A thing of no known kind, from its parts alone: what carries at the bottom, columns, boards or
/// piles on it, what rises above, what sits on the sides (data/create/parts.json says which part
/// goes where). What the parts need to hold together, such as a post for branches, is added. `size`
/// is about its box.
shape::Program compose(const Description& description, const Vec3& size);

/// Adds parts to a thing whose recipe knows none of their names. False if there is nothing that
/// could bear them.
bool attach(shape::Program& program, const std::vector<PartWish>& parts);

}  // namespace roomgen::create
