#include "scene/room_part.h"

#include <algorithm>
#include <array>

namespace roomgen {

namespace {

struct Share {
  std::string_view name;
  double of_all;
};
constexpr std::array shares = {Share{"half", 1.0 / 2.0}, Share{"two-thirds", 2.0 / 3.0},
                               Share{"third", 1.0 / 3.0}, Share{"quarter", 1.0 / 4.0}};

// Of a side: which axis it is on, and which end.
struct RegionSide {
  std::string_view name;
  int axis;
  bool high;
};
constexpr std::array region_sides = {RegionSide{"north", 1, true}, RegionSide{"south", 1, false},
                                     RegionSide{"east", 0, true}, RegionSide{"west", 0, false}};

const RegionSide* side_named(std::string_view name) {
  const auto found = std::find_if(region_sides.begin(), region_sides.end(),
                                  [&](const RegionSide& side) { return side.name == name; });
  return found == region_sides.end() ? nullptr : &*found;
}

// Leaves that share of a box at one of its sides.
void keep_side(Bounds2& box, const RegionSide& side, double share) {
  const double kept = share * box.size()[side.axis];
  if (side.high)
    box.low[side.axis] = box.high[side.axis] - kept;
  else
    box.high[side.axis] = box.low[side.axis] + kept;
}

void keep_middle(Bounds2& box, double share) {
  const int axis = box.size().x() >= box.size().y() ? 0 : 1;
  const double out = 0.5 * (1.0 - share) * box.size()[axis];
  box.low[axis] += out;
  box.high[axis] -= out;
}

Footprint thin(const Segment& segment, const Vec2& inward) {
  return Footprint(segment.middle(), {segment.length(), part_depth}, yaw_facing(inward));
}

}  // namespace

std::optional<Footprint> part_of_room(const Room& room, std::string_view name) {
  if (const Opening* opening = find_opening(room, name))
    return thin(segment(room, *opening), inward(room, *opening));
  for (std::size_t k = 0; k < room.polygon.size(); ++k)
    if (name == "wall-" + std::to_string(k))
      return thin(room.polygon.edge(k), room.polygon.inward(k));
  return std::nullopt;
}

std::vector<std::string> wall_names(const Room& room) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < room.polygon.size(); ++k) names.push_back("wall-" + std::to_string(k));
  return names;
}

std::optional<Footprint> region_of_room(const Room& room, std::string_view name) {
  const auto share = std::find_if(shares.begin(), shares.end(),
                                  [&](const Share& one) { return name.ends_with(one.name); });
  if (share == shares.end() || name.size() <= share->name.size() + 1) return std::nullopt;
  std::string_view where = name.substr(0, name.size() - share->name.size());
  if (where.back() != '-') return std::nullopt;
  where.remove_suffix(1);
  Bounds2 box = bounds(room.polygon);
  const auto dash = where.find('-');
  const RegionSide* first = side_named(where.substr(0, dash));
  const RegionSide* second =
      dash == std::string_view::npos ? nullptr : side_named(where.substr(dash + 1));
  if (where == "middle") {
    keep_middle(box, share->of_all);
  } else if (first && dash == std::string_view::npos) {
    keep_side(box, *first, share->of_all);
  } else if (first && second && first->axis != second->axis && share->name == "quarter") {
    keep_side(box, *first, 0.5);
    keep_side(box, *second, 0.5);
  } else {
    return std::nullopt;
  }
  return Footprint(0.5 * (box.low + box.high), box.size(), 0.0);
}

std::vector<std::string> region_names() {
  std::vector<std::string> names;
  for (const auto& share : shares) {
    names.push_back("middle-" + std::string(share.name));
    for (const auto& side : region_sides)
      names.push_back(std::string(side.name) + "-" + std::string(share.name));
  }
  for (const auto& one : region_sides)
    for (const auto& other : region_sides)
      if (one.axis > other.axis)
        names.push_back(std::string(one.name) + "-" + std::string(other.name) + "-quarter");
  return names;
}

bool is_part_of_room(const Room& room, std::string_view name) {
  return name == "corner" || name == nearest_wall || part_of_room(room, name) || region_of_room(room, name);
}

}  // namespace roomgen
