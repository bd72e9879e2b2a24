#pragma once

#include "roomgen/design/designer.h"

namespace roomgen::design {

/// What a plan says of a thing's place; where it says none the thing goes where its kind usually
/// does.
Result<PlaceAdvice> place_as_planned(const PlaceRequest& request);

}  // namespace roomgen::design
