#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fit_rugs.h"
#include "roomgen/geometry/polygon.h"

namespace roomgen {

/// What of a thing comes down to the floor, from above.
struct LowThing {
  const Object* object = nullptr;
  std::vector<Footprint> parts;
  bool may_be_lifted = true;  ///< else it must not be on the rug
};

/// How the parts of a thing stand to a rug; a thing that is nearer to a rug than `clear` is not
/// beside it.
RugStand stand_of(std::span<const Footprint> parts, const Footprint& rug, double clear = 0.0);

/// The rug where and as large as it should lie among these things: of all cuts on which they stand
/// with all their parts or none, within the room and off the doors' clearances, the one that
/// changes least and loses least (relations that hold, things that it was laid under). Nothing if
/// there is none.
std::optional<Object> rug_place(const Object& rug, const RugWish& wish, const Room& room,
                                std::span<const Object> objects, std::span<const LowThing> things,
                                const KindTable& kinds);

/// A rectangle of floor that a rug could cover, in the frame of the rug as it lay.
struct RugCut {
  Bounds2 area;
  double change = 0.0;  ///< metres: how much wider, deeper or smaller, and how far it lies from where it did
};

/// How far the sides of a rug may change, in parts of what they were.
struct RugRange {
  double least = 1.0, most = 1.0;
};

/// What is about a rug, in its frame.
struct AboutRug {
  std::vector<Bounds2> things;  ///< it may end just beyond them
  std::vector<Bounds2> parts;   ///< of the things: it may end just before them
  std::vector<Vec2> corners;    ///< of the room: it may reach as far
};

/// Ways to cut a rug of this size so that it ends where what is about it suggests, the smallest
/// change first. The first is the rug as it lay. A round one stays in shape.
std::vector<RugCut> rug_cuts(const Vec2& size, bool round, const RugRange& range, const AboutRug& about);

}  // namespace roomgen
