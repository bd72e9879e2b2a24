#pragma once

#include <vector>

#include "roomgen/create/maker.h"
#include "roomgen/geometry/model.h"

namespace roomgen::create {

/// What parts are placed on. Metres, in the frame of the shape program.
struct Frame {
  Vec3 size = Vec3::Ones();  ///< of the whole, of which parts' sizes are shares
  double low = 0.0;          ///< feet reach up to here
  double high = 0.0;         ///< columns, boards and piles end here
  Bounds3 core;              ///< what stands on the feet: fronts, sides and backs are its faces
  Bounds3 deck;              ///< what things stand on; its upper side
  bool framed = false;       ///< there are uprights at the sides
};

/// The place of one copy. Parts fill their size upward from `at`, centred, before they are turned
/// about the axes, X first, then moved.
struct Spot {
  Vec3 at = Vec3::Zero();
  Vec3 turn = Vec3::Zero();
  Vec3 size = Vec3::Ones();
  bool about_middle = false;  ///< turned about the middle of the size instead of its bottom
};

/// Where `count` copies of a part of about this size go. Sizes follow the place: feet become as
/// tall as the frame is high above the floor, copies share what room there is. `spread`: at many
/// heights.
std::vector<Spot> spots(Place place, int count, const Vec3& size, const Frame& frame,
                        const Series& series = {}, bool spread = false);

}  // namespace roomgen::create
