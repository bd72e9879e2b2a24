#pragma once

#include <vector>

#include "relation_score.h"
#include "roomgen/lab/scores.h"

namespace roomgen::lab {

/// What can be measured of a room without knowing what was asked for.
struct MeasuredRoom {
  RoomScore score;            ///< without verdicts
  std::vector<Thing> things;  ///< of the scene's objects, in their order
};

/// `scene` is of one room, `around` of the same.
MeasuredRoom measure_room(const Scene& scene, const ModelTable& models, const RoomSurfaces& around);

}  // namespace roomgen::lab
