#include <algorithm>

#include "physics.h"

namespace roomgen::lab::sceneeval {

namespace {

constexpr double window_depth = 0.5;

OrientedBox clearance_of(const Opening& opening, const Room& room) {
  const Segment edge = room.polygon.edge(opening.wall);
  const Vec2 inward = room.polygon.inward(opening.wall);
  const double width = opening.to - opening.from;
  const double depth = opening.is_entrance() ? width : window_depth;
  const Vec2 middle =
      edge.a + 0.5 * (opening.from + opening.to) * edge.direction() + 0.5 * depth * inward;
  return {{middle.x(), middle.y(), 0.5 * (opening.sill + opening.head)},
          {0.5 * width, 0.5 * depth, 0.5 * (opening.head - opening.sill)},
          yaw_facing(inward)};
}

}  // namespace

std::vector<std::vector<std::size_t>> in_the_way(std::span<const OrientedBox> boxes,
                                                 const Room& room) {
  std::vector<std::vector<std::size_t>> result;
  for (const auto& opening : room.openings) {
    const OrientedBox clearance = clearance_of(opening, room);
    auto& found = result.emplace_back();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const auto points = boxes[i].points();
      if (std::any_of(points.begin(), points.end(),
                      [&](const Vec3& point) { return clearance.contains(point); }))
        found.push_back(i);
    }
  }
  return result;
}

}  // namespace roomgen::lab::sceneeval
