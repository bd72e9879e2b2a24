#pragma once

#include <string>
#include <vector>

#include "workplace.h"

namespace roomgen {

/// Asks the designer for the place of an object, with why earlier answers did not fit, and keeps account of
/// what that took.
Result<PlaceAdvice> consult(Work& work, const PlannedObject& planned, const PlacementTask& task,
                            const std::vector<std::string>& refusals);

/// The advice decides what carries the object or what it hangs above, and so its height. `refused`: how
/// often it found no place already.
Status follow(const Work& work, const PlaceAdvice& advice, const PlannedObject& planned,
              std::size_t refused, PlacementTask& task);

}  // namespace roomgen
