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
  const double reach = 0.5 * zone.depth;
  switch (zone.side) {
    case Side::front:
      return Footprint(object.to_world({0, -half.y() - reach}), {2 * half.x(), zone.depth},
                       object.yaw());
    case Side::back:
      return Footprint(object.to_world({0, half.y() + reach}), {2 * half.x(), zone.depth},
                       object.yaw());
    case Side::left:
      return Footprint(object.to_world({half.x() + reach, 0}), {zone.depth, 2 * half.y()},
                       object.yaw());
    case Side::right:
      break;
  }
  return Footprint(object.to_world({-half.x() - reach, 0}), {zone.depth, 2 * half.y()},
                   object.yaw());
}

}  // namespace roomgen
