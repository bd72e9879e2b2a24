#include <algorithm>
#include <cmath>

#include "draft_changes.h"
#include "operations.h"
#include "plan/wall_stretch.h"
#include "roomgen/base/text.h"
#include "walls.h"

namespace roomgen {

namespace {

constexpr double at_wall = 0.12;    // metres from a wall that a thing stands at
constexpr double lowest_room = 1.8, highest_room = 12.0;
constexpr double least_turn = 1e-6;  // sine

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Where the line of a moved wall meets the one beside it.
std::optional<Vec2> meeting(const Segment& beside, const Vec2& point, const Vec2& direction) {
  const double turn = cross(beside.direction(), direction);
  if (std::abs(turn) < least_turn) return std::nullopt;
  return beside.a + beside.direction() * (cross(point - beside.a, direction) / turn);
}

void shift_openings(Room& room, std::size_t wall, double by) {
  for (auto& opening : room.openings)
    if (opening.wall == wall) opening.from += by, opening.to += by;
}

// The walls beside it grow or shrink; openings stay where they are, or go along with the wall.
Result<Room> with_moved_wall(const Room& room, std::size_t wall, double by) {
  const std::size_t n = room.polygon.size(), before = (wall + n - 1) % n, after = (wall + 1) % n;
  const Segment edge = room.polygon.edge(wall);
  const Vec2 point = edge.a - by * room.polygon.inward(wall);
  const auto first = meeting(room.polygon.edge(before), point, edge.direction());
  const auto second = meeting(room.polygon.edge(after), point, edge.direction());
  if (!first || !second) return cannot("a wall beside it runs on in the same line, and they would come apart");
  Room moved = room;
  moved.polygon.points[wall] = *first;
  moved.polygon.points[after] = *second;
  if ((*second - *first).dot(edge.direction()) < plan::between_openings)
    return cannot("nothing would be left of the wall");
  for (const std::size_t side : {before, after})
    if (moved.polygon.edge(side).direction().dot(room.polygon.edge(side).direction()) < 0.0 ||
        moved.polygon.edge(side).length() < plan::between_openings)
      return cannot("the room is not that deep");
  shift_openings(moved, wall, (edge.a - *first).dot(edge.direction()));
  shift_openings(moved, after, (edge.b - *second).dot(room.polygon.edge(after).direction()));
  return moved;
}

std::set<std::string> standing_at(const Scene& scene, const Room& room, std::size_t wall) {
  std::set<std::string> ids;
  for (const auto& object : scene.objects)
    if (object.room == room.id && object.on.empty() && object.mount != Mount::ceiling && !object.traits.flat &&
        gap(footprint(object), room.polygon.edge(wall)) <= at_wall)
      ids.insert(object.id);
  return ids;
}

}  // namespace

Status carry_out(Draft& draft, const edit::Reshape& reshape) {
  if (!draft.scene.rooms.empty())
    return cannot("a wall of a dwelling is the next room's wall too; only single rooms can change their shape");
  RoomChange change{draft.scene.room};
  if (reshape.height) {
    if (*reshape.height < lowest_room || *reshape.height > highest_room) return cannot("rooms are 1.8 to 12 m high");
    change.room.height = *reshape.height;
    draft.new_measures.insert("height");
    Requirement wish;
    wish.kind = Requirement::Kind::room;
    wish.source = Requirement::Source::edit;
    wish.attribute = "height";
    wish.amount = *reshape.height;
    wish.clause = format_number(*reshape.height, 2) + " m high";
    draft.wishes.push_back(std::move(wish));
  }
  if (!reshape.wall.empty()) {
    const auto wall = wall_named(change.room, reshape.wall);
    if (!wall) return wall.error();
    const auto moved = with_moved_wall(change.room, *wall, reshape.by);
    if (!moved) return cannot(reshape.wall + " cannot be moved so far: " + moved.error().message);
    if (bounds(moved->polygon).size().maxCoeff() > greatest_room_side)
      return cannot("rooms are " + format_number(greatest_room_side, 0) + " m long at most");
    change.along = standing_at(draft.scene, change.room, *wall);
    change.by = -reshape.by * change.room.polygon.inward(*wall);
    change.room = *moved;
    for (const char* measure : {"longer side", "shorter side", "area", "proportion", "shape"})
      draft.new_measures.insert(measure);
  }
  return change_room(draft, change);
}

}  // namespace roomgen
