#pragma once

#include <map>
#include <string>

#include "compiled.h"
#include "roomgen/scene/scene.h"
#include "world.h"

namespace roomgen::lab::annealing {

/// The room of a state as files hold it: things with ids by their kinds, carriers before what they carry, and the
/// relations that the ways in which they are put up amount to, as far as these hold.
struct Exported {
  Scene scene;
  std::map<Slot, std::string> ids;
};
Exported to_scene(const World& world, const KindTable& kinds);

}  // namespace roomgen::lab::annealing
