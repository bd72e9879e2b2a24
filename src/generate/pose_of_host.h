#pragma once

#include "workplace.h"

namespace roomgen {

/// Puts an object exactly where a host wants it, locked. not_found if it cannot stand there.
Status put_at(Work& work, const PlannedObject& planned, const WantedPose& pose, Step& step);

/// Puts an object where the relations, the location and the facing of a host lead. not_found if nowhere.
Status put_by(Work& work, const PlannedObject& planned, const PlaceAdvice& wish, Step& step);

}  // namespace roomgen
