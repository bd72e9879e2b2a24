#include "part_of_room.h"

#include <algorithm>
#include <cmath>

namespace roomgen::lab {

namespace {

constexpr double rounding = 1e-9;

bool leads_outdoors(const Opening& opening) {
  return opening.type == OpeningType::door && opening.leads_to.empty();
}

// Where one looks who comes in.
Vec2 way_in(const Room& room) {
  const auto& openings = room.openings;
  auto entrance = std::find_if(openings.begin(), openings.end(), leads_outdoors);
  if (entrance == openings.end())
    entrance = std::find_if(openings.begin(), openings.end(),
                            [](const Opening& opening) { return opening.is_entrance(); });
  return entrance == openings.end() ? Vec2(0, 1) : inward(room, *entrance);
}

Vec2 direction(RoomSide side, const Room& room) {
  switch (side) {
    case RoomSide::north: return {0, 1};
    case RoomSide::south: return {0, -1};
    case RoomSide::east: return {1, 0};
    case RoomSide::west: return {-1, 0};
    case RoomSide::front: return -way_in(room);
    case RoomSide::left: return left_of(way_in(room));
    case RoomSide::right: return -left_of(way_in(room));
    case RoomSide::rear:
    case RoomSide::middle: break;
  }
  return way_in(room);
}

// How far along the direction, 0 where the room begins and 1 where it ends.
double station(const Vec2& point, const Room& room, const Vec2& towards) {
  const auto [low, high] = std::minmax_element(
      room.polygon.points.begin(), room.polygon.points.end(),
      [&](const Vec2& a, const Vec2& b) { return a.dot(towards) < b.dot(towards); });
  const double begin = low->dot(towards);
  return (point.dot(towards) - begin) / (high->dot(towards) - begin);
}

}  // namespace

bool lies_in(const Vec2& point, const Room& room, const PartOfRoom& part) {
  const double share = part.sides.size() > 1 ? 0.5 : part.share;
  return std::all_of(part.sides.begin(), part.sides.end(), [&](RoomSide side) {
    const double at = station(point, room, direction(side, room));
    return side == RoomSide::middle ? std::abs(at - 0.5) <= 0.5 * share + rounding
                                    : at >= 1.0 - share - rounding && at <= 1.0 + rounding;
  });
}

}  // namespace roomgen::lab
