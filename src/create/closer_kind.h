#pragma once

#include "kinds.h"
#include "roomgen/create/maker.h"

namespace roomgen::create {

/// The kind that a description means when its place or its parts say more than its noun does: "a coat
/// rack for the wall" is a wall coat rack, "a chest of six drawers" a chest of drawers. Null if there
/// is none.
const ShapeKind* closer_kind(const Description& description, const ShapeKinds& kinds);

}  // namespace roomgen::create
