#pragma once

#include <vector>

#include "base/random.h"
#include "layout.h"
#include "roomgen/base/cancel.h"
#include "roomgen/scene/problem.h"

namespace roomgen {

/// Places a small thing on a support that is full by moving what stands there already: all of it,
/// with the newcomer, is arranged anew so that every constraint holds, or else all that was wished
/// for, or else so that everything at least stands on its support. `tasks` are the things of the
/// layout in placement order; locked ones and those without a task stay where they are, and if that will do
/// also those that somebody put there. Tells whether the newcomer is in the layout now; if not, nothing has moved.
bool make_room(Layout& layout, const PlacementTask& newcomer,
               const std::vector<PlacementTask>& tasks, const CancelToken& cancel, Random& random);

}  // namespace roomgen
