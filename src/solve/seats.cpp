#include "seats.h"

#include <algorithm>
#include <cmath>

namespace roomgen {

namespace {

constexpr int fewest_at_round = 2, most_at_round = 12, most_at_straight = 40;
constexpr double off_line = 0.03;
// From the rim to the front of a seat: farther away one sits behind another.
constexpr double at_rim = 0.2;

}  // namespace

std::vector<SeatPlace> seat_places(const Footprint& table, int count) {
  if (!table.round()) return composition::seat_places(table, std::min(count, most_at_straight));
  const Footprint turned(table.center(), 2.0 * table.half(), table.yaw() + pi / 2, true);
  return composition::seat_places(turned, std::clamp(count, fewest_at_round, most_at_round));
}

bool is_at(const SeatPlace& place, const Footprint& footprint) {
  const Vec2 off = footprint.center() - place.rim;
  const double away = off.dot(place.outward);
  return away > 0 && away < footprint.half().y() + at_rim &&
         std::abs(cross(place.outward, off)) < off_line;
}

}  // namespace roomgen
