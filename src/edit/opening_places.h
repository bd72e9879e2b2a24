#pragma once

#include <optional>
#include <vector>

#include "roomgen/scene/scene.h"

namespace roomgen {

/// Where an opening may be: on one wall or all, its middle at a place along it or anywhere; clear of corners, of
/// other openings and of other rooms' walls. Those with the fewest things before them come first, then those
/// nearest to the middle of their wall.
std::vector<Opening> opening_places(const Scene& scene, const Room& room, const Opening& wanted,
                                    const std::optional<std::size_t>& wall, const std::optional<double>& at);

}  // namespace roomgen
