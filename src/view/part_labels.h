#pragma once

#include "label_placer.h"
#include "roomgen/scene/room.h"
#include "camera.h"

namespace roomgen::detail {

/// The ids of walls, doors and windows beside them, as far as there is room: outside, else inside.
void place_part_labels(const Room& room, const Camera& camera, double letter_height,
                       LabelPlacer& placer, bool inside_only = false);

}  // namespace roomgen::detail
