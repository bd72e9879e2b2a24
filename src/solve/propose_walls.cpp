#include "proposals.h"

#include <algorithm>

#include "trials.h"

namespace roomgen {

namespace {

constexpr double along_wall_pitch = 0.10;

// The centres along a wall, measured from its start, at which a thing of this width is worth
// trying: regular steps, both ends, the middle, beside openings and neighbours, opposite targets.
std::vector<double> stations(const ProposalContext& context, std::size_t wall, double width, double pitch) {
  const Room& room = context.layout.room();
  const Segment line = room.polygon.edge(wall);
  const double length = line.length();
  const double first = 0.5 * width + flush, last = length - 0.5 * width - flush;
  std::vector<double> result;
  if (last < first) {
    if (length + 1e-3 >= width) result.push_back(0.5 * length);
    return result;
  }
  for (double s = first; s < last; s += pitch) result.push_back(s);
  const auto add = [&](double s) {
    if (s >= first - 1e-9 && s <= last + 1e-9) result.push_back(s);
  };
  const auto add_beside = [&](double low, double high) {
    add(low - 0.5 * width - flush);
    add(high + 0.5 * width + flush);
    add(0.5 * (low + high));
  };
  add(last);
  add(0.5 * length);
  if (context.suggestion.binds && context.suggestion.location)
    add((*context.suggestion.location - line.a).dot(line.direction()));
  for (const auto& opening : room.openings)
    if (opening.wall == wall) add_beside(opening.from, opening.to);
  const Vec2 along = line.direction(), inward = left_of(along);
  const double depth = size_of(context).y() + flush;
  for (const auto& thing : context.layout.things()) {
    double low = 1e300, high = -1e300, off = 1e300;
    for (const auto& corner : thing.footprint.outline()) {
      const double s = (corner - line.a).dot(along);
      low = std::min(low, s), high = std::max(high, s);
      off = std::min(off, (corner - line.a).dot(inward));
    }
    if (off < depth) add_beside(low, high);  // others stand clear of the wall
  }
  for (const auto& relation : context.relations)
    for (const auto& target : relation.targets) {
      if (!takes_target(relation.kind)) continue;
      add((target.center() - line.a).dot(line.direction()));
      if (relation.other)
        add((0.5 * (target.center() + relation.other->center()) - line.a).dot(line.direction()));
    }
  return result;
}

}  // namespace

void propose_at_walls(const ProposalContext& context, std::vector<Pose>& poses) {
  const Vec2 size = size_of(context);
  const Polygon& polygon = context.layout.room().polygon;
  const double pitch = step_within_limit(along_wall_pitch, polygon);
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Segment line = polygon.edge(k);
    const Vec2 inward = polygon.inward(k);
    const double yaw = yaw_facing(inward);
    for (double s : stations(context, k, size.x(), pitch))
      poses.push_back({line.a + s * line.direction() + (0.5 * size.y() + flush) * inward,
                       mounting_height(context), yaw});
  }
}

}  // namespace roomgen
