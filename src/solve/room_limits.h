#pragma once

#include <span>
#include <vector>

#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/object.h"
#include "roomgen/scene/room.h"

namespace roomgen {

/// Where the room itself lets a thing be: inside, below the ceiling, off the clearances of doors and windows.
class RoomLimits {
 public:
  /// `room` must outlive this.
  explicit RoomLimits(const Room& room);

  /// May the object be there, as far as the room is concerned? Its own pose does not count.
  bool admit(const Object& object, const Kind& kind, const Footprint& footprint, double bottom) const;

  /// Is there a wall right behind it, as far as it is wide?
  bool is_at_wall(const Footprint& footprint) const;

  /// The clearances of doors and passages.
  std::span<const Footprint> door_areas() const { return door_areas_; }
  /// The strips before windows where the object, from the floor up, is too high to stand.
  std::vector<Footprint> areas_before_windows(const Object& object) const;

 private:
  struct Clearance {
    Footprint area;
    double from;  ///< things that reach above `from` and start below `to` must keep off
    double to;
    bool of_window;  ///< where curtains and blinds belong
  };
  bool holds(const Footprint& footprint) const;

  const Room& room_;
  bool is_box_ = false;  ///< the room is an axis-aligned rectangle
  Bounds2 bounds_;
  std::vector<Clearance> clearances_;
  std::vector<Footprint> door_areas_;
};

}  // namespace roomgen
