#pragma once

#include "arrangement.h"
#include "roomgen/design/designer.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::design {

/// Where an object goes: what the plan asks for first, then what its kind is used to, as far as
/// both can hold in the room as it is. The relations of the answer hold at the suggested pose, but
/// for those of the plan, which are kept in any case.
PlaceAdvice advise(const PlaceRequest& request, const KindTable& categories,
                   const Arrangements& arrangements);

}  // namespace roomgen::design
