#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fit_rugs.h"

namespace roomgen {

/// What of a thing comes down to the floor, from above.
struct LowThing {
  const Object* object = nullptr;
  std::vector<Footprint> parts;
  bool may_be_lifted = true;  ///< else it must not be on the rug
};

/// How the parts of a thing stand to a rug; a thing that is nearer to a rug than `clear` is not beside it.
RugStand stand_of(std::span<const Footprint> parts, const Footprint& rug, double clear = 0.0);

/// The rug where and as large as it should lie among these things: of all cuts on which they stand with all
/// their parts or none, within the room and off the doors' clearances, the one that changes least and loses
/// least (relations that hold, things that it was laid under). Nothing if there is none.
std::optional<Object> rug_place(const Object& rug, const RugWish& wish, const Room& room,
                                std::span<const Object> objects, std::span<const LowThing> things,
                                const KindTable& kinds);

}  // namespace roomgen
