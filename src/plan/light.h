#pragma once

#include "brief/brief.h"

namespace roomgen::plan {

/// What the words of a prompt say of the light: "a candlelit evening" (the moods of data/materials.json). Words
/// that describe a thing or are denied say nothing. The brief hears them.
Lighting light_of(brief::Brief& brief);

/// Says what is still open.
void fill(Lighting& light, const Lighting& more);

}  // namespace roomgen::plan
