#pragma once

#include "finding.h"
#include "roomgen/scene/room.h"

namespace roomgen {

/// Whether a room is as a requirement of Kind::room asks: measured on its polygon and openings.
/// docs/requirements.md lists what may be asked.
Finding judge_room(const Requirement& requirement, const Room& room);

}  // namespace roomgen
