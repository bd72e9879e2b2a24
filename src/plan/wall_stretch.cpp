#include "wall_stretch.h"

#include <algorithm>
#include <utility>

namespace roomgen::plan {

std::vector<WallStretch> whole_walls(const Room& room) {
  std::vector<WallStretch> walls;
  for (std::size_t k = 0; k < room.polygon.size(); ++k)
    walls.push_back({k, 0.0, room.polygon.edge(k).length()});
  return walls;
}

std::vector<WallStretch> bare_walls(const Room& room) {
  auto bare = whole_walls(room);
  for (const auto& opening : room.openings)
    cut(bare, opening.wall, opening.from - between_openings, opening.to + between_openings);
  return bare;
}

void cut(std::vector<WallStretch>& stretches, std::size_t wall, double from, double to) {
  std::vector<WallStretch> rest;
  for (const auto& part : stretches) {
    if (part.wall != wall || from >= part.to || to <= part.from) {
      rest.push_back(part);
      continue;
    }
    if (from > part.from) rest.push_back({wall, part.from, from});
    if (to < part.to) rest.push_back({wall, to, part.to});
  }
  std::erase_if(rest, [](const WallStretch& part) { return part.length() < 1e-6; });
  stretches = std::move(rest);
}

Opening moved_to(Opening opening, const WallStretch& stretch, double middle, double offset) {
  const double width = opening.width();
  const double spare = std::max(0.0, stretch.length() - width);
  const double off = std::min(offset, 0.5 * spare);
  const double along = std::clamp(middle * stretch.length() - 0.5 * width, off, spare - off);
  opening.wall = stretch.wall;
  opening.from = stretch.from + along;
  opening.to = opening.from + width;
  // The leaf opens against the wall that is nearer.
  if (opening.type == OpeningType::door) opening.hinge_at_from = middle <= 0.5;
  return opening;
}

}  // namespace roomgen::plan
