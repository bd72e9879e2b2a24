#pragma once

#include <vector>

#include "base/random.h"
#include "layout.h"
#include "roomgen/base/cancel.h"
#include "roomgen/scene/problem.h"

namespace roomgen {

/// Places each thing once more by itself, without chance, and keeps what is better: searches leave
/// some a little off.
void polish(Layout& layout, const std::vector<PlacementTask>& tasks, PlaceOptions options,
            const CancelToken& cancel, Random& random);

}  // namespace roomgen
