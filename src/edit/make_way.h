#pragma once

#include "placing.h"

namespace roomgen {

/// find_place() in the draft's room; where there is no room, a bounded repair: as few unlocked neighbours as
/// can be, up to three, move as little as can be, and all their relations and all requirements that held still
/// hold. What moved is in the draft, and in Draft::repairs. If even that fails, the error names the smallest
/// set of up to three neighbours without which there would be a place. The cluster is put into the draft.
Status place_or_make_way(Draft& draft, const Cluster& cluster, const Aim& aim);

}  // namespace roomgen
