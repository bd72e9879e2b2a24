#pragma once

#include <vector>

#include "base/random.h"
#include "roomgen/library/library.h"
#include "scene/opening_kind.h"

namespace roomgen {

/// The meshes of a library for the doors and windows of a room that have none, by their kinds
/// (data/openings.json) and sizes: a mesh is stretched by no more than 0.75 to 1.3 in width and
/// height, and what finds none keeps the room's own woodwork. Openings of one kind share a mesh
/// where it fits; among meshes that fit about equally well the random numbers decide. A window
/// whose mesh has an outline takes that outline. Returns the assets used, without repetition.
Result<std::vector<AssetInfo>> fit_openings(Room& room, const OpeningKinds& kinds,
                                            const AssetLibrary& library, const Random& random);

}  // namespace roomgen
