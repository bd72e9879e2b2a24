#pragma once

#include <string>
#include <vector>

#include "roomgen/view/view.h"

namespace roomgen {

/// What is said of a part of a room ("wall-2") outside of it.
std::string part_id(const Room& room, const std::string& part);

/// All that a scene's pictures may show: its objects, then of each room the floor, the walls, the ceiling and the
/// openings. Fails if there are more than numbers.
Result<std::vector<LayerThing>> layer_things(const Scene& scene);

/// Fills in categories, and the things' pixels.
void count_pixels(Layers& layers);

}  // namespace roomgen
