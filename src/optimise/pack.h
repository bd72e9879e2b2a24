#pragma once

#include <cstdint>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/model_table.h"
#include "roomgen/scene/object.h"
#include "roomgen/scene/room.h"

namespace roomgen {

/// One thing that a room shall hold.
struct PackThing {
  Object object;         ///< at its pose, if it stands; with its relations
  bool stands = false;
  bool movable = true;   ///< else it stays where it stands
  bool asked = false;    ///< leaving it out is worse than leaving out what was merely added
  int wishes = 0;        ///< so many of its relations, the first ones, were asked for
};

struct PackOptions {
  std::uint64_t seed = 0;
  int steps = 30000;
  CancelToken cancel;
};

struct Packing {
  std::vector<Object> objects;  ///< those that stand, in the order of the things
  bool is_better = false;       ///< than what stood: more of what was asked for, then more things, then more relations
};

/// Looks for an arrangement of all things by the annealing of constraint programs: each thing is asked for once, its relations
/// are constraints with the meaning of scene/judgement, and clusters move as one. What stood before stays when nothing better
/// is found. Valid always (docs/constraints.md).
Packing pack(const Room& room, const std::vector<PackThing>& things, const ModelTable& models, const KindTable& kinds,
             const PackOptions& options);

}  // namespace roomgen
