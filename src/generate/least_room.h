#pragma once

#include "roomgen/generate/generate.h"

namespace roomgen {

/// What check_kind() said of a plan's room, with the least rectangle in which the same things, with
/// a door as such a room has and no windows, make one: measured by furnishing it.
Error with_least_room(const Error& too_small, const Plan& plan, const AssetLibrary& library,
                      const KindTable& categories, const BuildOptions& options);

}  // namespace roomgen
