#include "seats.h"

#include <algorithm>
#include <cmath>

#include "roomgen/kinds/kind_table.h"

namespace roomgen {

namespace {

constexpr int fewest_at_round = 2, most_at_round = 12, most_at_straight = 40;
constexpr double off_line = 0.03;
// From the rim to the front of a seat: farther away one sits behind another.
constexpr double at_rim = 0.2;

}  // namespace

std::vector<SeatPlace> seat_places_at_side(const Footprint& table, int side, int count) {
  const bool across = side >= 2;
  const double sign = side == 0 || side == 3 ? -1.0 : 1.0;
  const Vec2 normal = across ? Vec2(sign, 0) : Vec2(0, sign);
  const double length = 2.0 * (across ? table.half().y() : table.half().x());
  std::vector<SeatPlace> places;
  for (int i = 0; i < count; ++i) {
    const double along = ((i + 0.5) / count - 0.5) * length;
    const Vec2 local = normal.cwiseProduct(table.half()) + along * normal.cwiseAbs().reverse();
    places.push_back({table.to_world(local), rotated(normal, table.yaw())});
  }
  return places;
}

std::vector<SeatPlace> seat_places(const Footprint& table, int count) {
  std::vector<SeatPlace> places;
  if (table.round()) {
    const int number = std::clamp(count, fewest_at_round, most_at_round);
    for (int i = 0; i < number; ++i) {
      const Vec2 outward = rotated({1, 0}, table.yaw() + 2 * pi * i / number);
      places.push_back({table.center() + table.half().x() * outward, outward});
    }
    return places;
  }
  count = std::min(count, most_at_straight);
  const bool wide = table.half().x() >= table.half().y();
  const int most = std::max(1, static_cast<int>(2.0 * table.half().maxCoeff() / seat_width));
  const bool ends = count > 4 || (count > 2 && most < 2);
  const int at_sides = ends ? count - 2 : count;
  const int numbers[4] = {(at_sides + 1) / 2, at_sides / 2, ends ? 1 : 0, ends ? 1 : 0};
  for (int k = 0; k < 4; ++k) {
    const auto some = seat_places_at_side(table, wide ? k : (k + 2) % 4, numbers[k]);
    places.insert(places.end(), some.begin(), some.end());
  }
  return places;
}

bool is_at(const SeatPlace& place, const Footprint& footprint) {
  const Vec2 off = footprint.center() - place.rim;
  const double away = off.dot(place.outward);
  return away > 0 && away < footprint.half().y() + at_rim &&
         std::abs(cross(place.outward, off)) < off_line;
}

}  // namespace roomgen
