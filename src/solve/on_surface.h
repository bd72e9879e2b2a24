#pragma once

#include "propose.h"

namespace roomgen {

/// How well a thing stands on the surface of another one, in [0, 1]: on the surface that one takes
/// first (a table's top, a shelf's boards within reach), turned to who uses it, not at the very edge.
/// 1 for what does not stand on anything.
double rest_degree(const ProposalContext& context, const Footprint& footprint, double bottom);

}  // namespace roomgen
