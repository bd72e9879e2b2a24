#include <algorithm>

#include "roomgen/kinds/kind_table.h"

namespace roomgen {

double turn_of(Side side) {
  switch (side) {
    case Side::front: return 0.0;
    case Side::back: return pi;
    case Side::left: return pi / 2;
    case Side::right: break;
  }
  return -pi / 2;
}

Footprint zone_footprint(const Footprint& object, const UseZone& zone) {
  const Vec2 half = object.half();
  const bool is_turned = zone.lengthwise && half.x() > half.y();
  const bool is_left = zone.side == Side::left, is_right = zone.side == Side::right;
  if (!is_turned && (is_left || is_right)) {
    const double inset = std::clamp(zone.inset, 0.0, half.y());
    const double x = half.x() + 0.5 * zone.depth;
    return Footprint(object.to_world({is_left ? x : -x, -0.5 * inset}),
                     {zone.depth, 2 * half.y() - inset}, object.yaw());
  }
  const bool is_before = zone.side == Side::front || is_left;
  const double y = half.y() + 0.5 * zone.depth;
  return Footprint(object.to_world({0, is_before ? -y : y}), {2 * half.x(), zone.depth},
                   object.yaw());
}

}  // namespace roomgen
