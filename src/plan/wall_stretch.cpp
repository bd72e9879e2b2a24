#include "wall_stretch.h"

#include <algorithm>
#include <utility>

namespace roomgen::design {

namespace {

constexpr double narrowest_door = 0.3;

}  // namespace

WallStretch whole_wall(const Room& room, std::size_t wall) {
  return {wall, 0.0, room.polygon.edge(wall).length()};
}

void cut(std::vector<WallStretch>& stretches, double from, double to) {
  std::vector<WallStretch> rest;
  for (const auto& part : stretches) {
    if (from > part.from) rest.push_back({part.wall, part.from, std::min(part.to, from)});
    if (to < part.to) rest.push_back({part.wall, std::max(part.from, to), part.to});
  }
  std::erase_if(rest, [](const WallStretch& part) { return part.length() < 1e-6; });
  stretches = std::move(rest);
}

StretchEnds ends_for(const WallStretch& stretch, double width) {
  const double offset = std::min(corner_offset, std::max(0.0, 0.5 * (stretch.length() - width)));
  return {stretch.from + offset, stretch.to - offset - width};
}

double middle_for(const WallStretch& stretch, double width) {
  return 0.5 * (stretch.from + stretch.to - width);
}

double door_width(double usual, const WallStretch& stretch) {
  return std::min(usual, std::max(narrowest_door, stretch.length() - door_margin));
}

Opening opening_at(OpeningType type, std::size_t wall, double from, double width, double head) {
  Opening made;
  made.type = type;
  made.wall = wall;
  made.from = from;
  made.to = from + width;
  made.head = head;
  return made;
}

void move_to(Opening& opening, double from) {
  const double width = opening.width();
  opening.from = from;
  opening.to = from + width;
}

}  // namespace roomgen::design
