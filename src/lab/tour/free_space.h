#pragma once

#include <span>
#include <vector>

#include "roomgen/geometry/polygon.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/scene.h"

namespace roomgen::lab::detail {

/// What a camera must keep away from: walls, what is at the height of the eye and, carried by a person, what blocks
/// feet or body. Doors and passages between the rooms of a dwelling are open, as high as they are.
class FreeSpace {
 public:
  FreeSpace(const Scene& scene, const KindTable& kinds, double eye_height, double radius, bool flies);

  double radius() const { return radius_; }
  const Bounds2& extent() const { return extent_; }
  /// Metres to the nearest wall or thing, as far as `farthest`.
  double clearance(const Vec2& place, double farthest) const;
  /// Does the disc of the agent stay free all the way?
  bool is_free(const Segment& way) const;

 private:
  void add_walls(std::span<const Room> rooms, const Room& room);

  double radius_, eye_height_;
  Bounds2 extent_;
  std::vector<Segment> walls_;
  std::vector<Footprint> things_;
};

}  // namespace roomgen::lab::detail
