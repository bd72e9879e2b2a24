#pragma once

#include <string>
#include <vector>

#include "workplace.h"

namespace roomgen {

/// Takes up what the advice says otherwise than the plan does of this object alone: how high it hangs, how
/// large it is. False if there is nothing of that.
bool amend(Work& work, const PlannedObject& planned, const PlaceAdvice& advice);

/// Moves things that stand, the first of a group with all of it, and all that stands on them; each
/// move is made as a whole or not at all. What could not be done, in words.
std::vector<std::string> move_standing(Work& work, const std::vector<WantedMove>& moves);

}  // namespace roomgen
