#pragma once

#include "build_state.h"
#include "roomgen/base/result.h"
#include "workplace.h"

namespace roomgen {

/// What RoomBuilder::check_kind() says of a room that has come so far.
Status check_kind(const Workplace& place, const BuildState& state);

}  // namespace roomgen
