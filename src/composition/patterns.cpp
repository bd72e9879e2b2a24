#include "patterns.h"

#include <algorithm>

namespace roomgen::composition {

Place within(const Place& frame, const Place& place) {
  return {frame.position + rotated(place.position, frame.yaw), wrap_angle(frame.yaw + place.yaw)};
}

Vec2 outward(Side side) {
  switch (side) {
    case Side::front:
      return {0, -1};
    case Side::back:
      return {0, 1};
    case Side::left:
      return {1, 0};
    case Side::right:
      break;
  }
  return {-1, 0};
}

std::vector<double> in_a_row(int count, double length, double pitch) {
  std::vector<double> middles;
  const double step = pitch > 0.0 ? pitch : length / std::max(1, count);
  for (int i = 0; i < count; ++i) middles.push_back((i - 0.5 * (count - 1)) * step);
  return middles;
}

std::vector<SeatPlace> seat_places_at_side(const Footprint& table, Side side, int count) {
  const Vec2 normal = outward(side);
  const double length = 2.0 * normal.cwiseAbs().reverse().dot(table.half());
  std::vector<SeatPlace> places;
  for (double along : in_a_row(count, length, 0.0))
    places.push_back(
        {table.to_world(normal.cwiseProduct(table.half()) + along * normal.cwiseAbs().reverse()),
         rotated(normal, table.yaw())});
  return places;
}

std::vector<SeatPlace> seat_places(const Footprint& table, int count) {
  constexpr int most_at_round = 16, most_at_straight = 60;
  std::vector<SeatPlace> places;
  if (table.round()) {
    const int number = std::clamp(count, 1, most_at_round);
    for (int i = 0; i < number; ++i) {
      const Vec2 away = rotated({0, -1}, table.yaw() + 2 * pi * i / number);
      places.push_back({table.center() + table.half().x() * away, away});
    }
    return places;
  }
  count = std::clamp(count, 1, most_at_straight);
  const bool wide = table.half().x() >= table.half().y();
  const int most = std::max(1, static_cast<int>(2.0 * table.half().maxCoeff() / seat_width));
  const bool ends = count > 4 || (count > 2 && most < 2);
  const int at_sides = ends ? count - 2 : count;
  const int numbers[4] = {(at_sides + 1) / 2, at_sides / 2, ends ? 1 : 0, ends ? 1 : 0};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto some =
        seat_places_at_side(table, static_cast<Side>(wide ? k : (k + 2) % 4), numbers[k]);
    places.insert(places.end(), some.begin(), some.end());
  }
  return places;
}

}  // namespace roomgen::composition
