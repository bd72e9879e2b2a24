#pragma once

#include "design.h"
#include "roomgen/scene/room.h"

namespace roomgen::book {

/// Turns and mirrors a design so that it suits a room that there is: what stands at walls keeps
/// clear of doors, tall things of windows, what is at a window finds one. Sets `is_mirrored`,
/// `turns` and `openings` of the setting, whose size is that of the room's box.
void suit(const Design& design, const Room& room, Setting& setting);

}  // namespace roomgen::book
