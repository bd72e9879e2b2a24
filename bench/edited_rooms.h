#pragma once

#include <memory>
#include <string>
#include <vector>

#include "roomgen/library/library.h"
#include "roomgen/scene/scene.h"

namespace roomgen::bench {

/// All furniture that is installed, and what can be made of words; meshes are read once.
std::unique_ptr<AssetLibrary> open_furniture();

/// The rooms of bench/edits/rooms.txt, one a line, by rules.
std::vector<Scene> rooms_to_edit(const AssetLibrary& library);
/// The room of bench/rooms/full-living-room.txt: 44 things.
Scene full_room(const AssetLibrary& library);

}  // namespace roomgen::bench
