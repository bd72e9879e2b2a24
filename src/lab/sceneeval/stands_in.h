#pragma once

#include "thing.h"

namespace roomgen::lab {

/// 1 for what stands in a vessel and rises out of it, a plant in a pot, where SceneEval's inside_of
/// asks for half of its box: the middle of its foot is in the anchor's box, above the ground that
/// the anchor stands on (a stool under a desk is not in it) and not on its top.
double stands_in(const Thing& target, const Thing& anchor);

}  // namespace roomgen::lab
