#pragma once

#include <span>
#include <vector>

#include "roomgen/geometry/polygon.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/scene.h"

namespace roomgen::detail {

/// What a camera carried by a person must keep away from: walls, what blocks feet or body, and what is at the height
/// of the eye. Doors and passages between the rooms of a dwelling are open.
class FreeSpace {
 public:
  FreeSpace(const Scene& scene, const KindTable& kinds, double eye_height, double radius);

  double radius() const { return radius_; }
  const Bounds2& extent() const { return extent_; }
  /// Metres to the nearest wall or thing, as far as `farthest`.
  double clearance(const Vec2& place, double farthest) const;
  /// Does the disc of the agent stay free all the way?
  bool is_free(const Segment& way) const;

 private:
  void add_walls(std::span<const Room> rooms, const Room& room);

  double radius_;
  Bounds2 extent_;
  std::vector<Segment> walls_;
  std::vector<Footprint> things_;
};

}  // namespace roomgen::detail
