#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/room.h"

namespace roomgen {

/// How a curtain or blind (Kind::covers_window) may hang at a window: before the middle of it,
/// its rod above the head. The first is as wide as usual and, if its kind reaches lower than the
/// sill, down to its usual height over the floor; then it ends under the sill, as over furniture,
/// then it is no wider than the hole, and at last it is drawn up to the middle, over what stands on
/// that furniture. Before all of them it is as short as was said (`height`, metres): a valance, a
/// blind that is rolled up. Each is the object with size and pose; none where the wall leaves no
/// room.
std::vector<Object> hangings(const Object& object, const Kind& category, const Room& room,
                             const Opening& window, std::optional<double> height = std::nullopt);

/// The windows, those first at which nothing of this kind hangs yet.
std::vector<const Opening*> windows_to_cover(const Room& room, std::span<const Object> objects,
                                             const std::string& category);

}  // namespace roomgen
