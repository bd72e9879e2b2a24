#include "room_limits.h"

#include <algorithm>
#include <cmath>

namespace roomgen {

namespace {

// Half of what a finished scene may cross: files round poses and rooms.
constexpr double inside_tolerance = 5e-4;

bool is_axis_aligned_rectangle(const Room& room) {
  return room.polygon.size() == 4 &&
         std::abs(area(room.polygon) - bounds(room.polygon).size().prod()) < 1e-9;
}

}  // namespace

RoomLimits::RoomLimits(const Room& room)
    : room_(room), is_box_(is_axis_aligned_rectangle(room)), bounds_(bounds(room.polygon)) {
  for (const auto& opening : room.openings) {
    if (opening.is_entrance()) door_areas_.push_back(door_clearance(room, opening));
    for (const auto& area : clearances(room, opening))
      clearances_.push_back({area, opening.is_entrance() ? 0.0 : opening.sill + window_overlap,
                             opening.head, !opening.is_entrance()});
  }
}

bool RoomLimits::holds(const Footprint& footprint) const {
  if (!is_box_) return contains(room_.polygon, footprint, inside_tolerance);
  const Bounds2& box = footprint.bounds();
  return (box.low - bounds_.low).minCoeff() >= -inside_tolerance &&
         (bounds_.high - box.high).minCoeff() >= -inside_tolerance;
}

bool RoomLimits::admit(const Object& object, const Kind& kind, const Footprint& footprint,
                       double bottom) const {
  const double top = bottom + object.size.z();
  if (top > room_.height + inside_tolerance || !holds(footprint)) return false;
  if (object.traits.flat || object.mount == Mount::surface) return true;
  return std::none_of(clearances_.begin(), clearances_.end(), [&](const Clearance& clearance) {
    if (clearance.of_window && kind.covers_window) return false;
    // What stands before a window may hide a little of it; what hangs keeps clear of it.
    const bool hangs = clearance.of_window && object.mount == Mount::wall;
    return top > clearance.from - (hangs ? window_overlap : 0.0) && bottom < clearance.to &&
           overlaps(footprint, clearance.area, inside_tolerance);
  });
}

bool RoomLimits::is_at_wall(const Footprint& footprint) const {
  constexpr double close = 0.06;
  const Vec2 half = footprint.half();
  const auto near_wall = [&](const Vec2& corner) {
    const Vec2 at = footprint.to_world(corner);
    for (std::size_t k = 0; k < room_.polygon.size(); ++k)
      if (distance(room_.polygon.edge(k), at) <= close &&
          room_.polygon.inward(k).dot(footprint.front()) > 0.99)
        return true;
    return false;
  };
  return near_wall({half.x(), half.y()}) && near_wall({-half.x(), half.y()});
}

std::vector<Footprint> RoomLimits::areas_before_windows(const Object& object) const {
  std::vector<Footprint> areas;
  if (object.mount != Mount::floor || object.traits.flat) return areas;
  for (const auto& clearance : clearances_)
    if (clearance.of_window && object.size.z() > clearance.from) areas.push_back(clearance.area);
  return areas;
}

}  // namespace roomgen
