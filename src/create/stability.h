#pragma once

#include "search.h"

namespace roomgen::create::detail {

/// Widens what stands on the ground, or moves it and what is above it over each other.
void try_steadying(Trials& trials);

}  // namespace roomgen::create::detail
