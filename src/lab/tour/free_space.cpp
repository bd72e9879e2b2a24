#include "free_space.h"

#include <algorithm>

#include "collision/usability.h"
#include "scene/dwelling.h"

namespace roomgen::lab::detail {

namespace {

constexpr double rounding = 1e-6;   // a gap of exactly the agent's width is passable
constexpr double head_room = 0.1;   // above and below the eye

bool at_eye_height(const Object& object, double eye_height) {
  return bottom(object) < eye_height + head_room && top(object) > eye_height - head_room;
}

bool leads_inside(std::span<const Room> rooms, const Room& room, const Opening& opening) {
  return opening.is_entrance() && other_side(rooms, room, opening) != nullptr;
}

Bounds2 bounds_of(const Segment& segment) {
  Bounds2 box;
  box.add(segment.a), box.add(segment.b);
  return box;
}

}  // namespace

FreeSpace::FreeSpace(const Scene& scene, const KindTable& kinds, double eye_height, double radius,
                     bool flies)
    : radius_(radius), eye_height_(eye_height) {
  const auto rooms = rooms_of(scene);
  for (const auto& room : rooms) add_walls(rooms, room);
  for (const auto& object : scene.objects)
    if ((!flies && blocks_floor(object, kinds.get(object.category))) || at_eye_height(object, eye_height))
      things_.push_back(footprint(object));
}

// The wall is left out where an open door is; the hole's sides go through to the next room.
void FreeSpace::add_walls(std::span<const Room> rooms, const Room& room) {
  for (const auto& point : room.polygon.points) extent_.add(point);
  std::vector<std::vector<std::pair<double, double>>> holes(room.polygon.size());
  for (const auto& opening : room.openings) {
    if (!leads_inside(rooms, room, opening) || opening.head <= eye_height_) continue;
    holes[opening.wall].emplace_back(opening.from, opening.to);
    const Segment hole = segment(room, opening);
    const Vec2 through = -wall_thickness * inward(room, opening);
    for (const Vec2& side : {hole.a, hole.b}) walls_.push_back({side, side + through});
  }
  for (std::size_t k = 0; k < room.polygon.size(); ++k) {
    const Segment edge = room.polygon.edge(k);
    const Vec2 along = edge.direction();
    std::sort(holes[k].begin(), holes[k].end());
    double from = 0.0;
    for (const auto& [start, end] : holes[k]) {
      walls_.push_back({edge.a + from * along, edge.a + start * along});
      from = end;
    }
    walls_.push_back({edge.a + from * along, edge.b});
  }
}

double FreeSpace::clearance(const Vec2& place, double farthest) const {
  Bounds2 here;
  here.add(place);
  double least = farthest;
  for (const auto& wall : walls_) least = std::min(least, distance(wall, place));
  for (const auto& thing : things_)
    if (here.overlaps(thing.bounds(), least)) least = std::min(least, gap(thing, place));
  return least;
}

bool FreeSpace::is_free(const Segment& way) const {
  const Bounds2 box = bounds_of(way);
  const double limit = radius_ - rounding;
  const auto in_the_way = [&](const Bounds2& bounds) { return box.overlaps(bounds, radius_); };
  return std::none_of(walls_.begin(), walls_.end(), [&](const Segment& wall) {
           return in_the_way(bounds_of(wall)) && distance(wall, way) < limit;
         }) &&
         std::none_of(things_.begin(), things_.end(), [&](const Footprint& thing) {
           return in_the_way(thing.bounds()) && gap(thing, way) < limit;
         });
}

}  // namespace roomgen::lab::detail
