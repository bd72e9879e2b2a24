#include <cmath>

#include "base/random.h"
#include "brief/room_kinds.h"
#include "plan/floor_plan.h"
#include "roomgen/lab/optimise.h"

namespace roomgen::lab {

namespace {

using brief::RoomKind;

double drawn(const Range& range, Random& random) {
  return range.low == range.high ? range.low : random.uniform(range.low, range.high);
}

double to_centimetres(double metres) { return std::round(metres * 100.0) / 100.0; }

// Width and depth, as far as the program says; what it leaves open is as the kind has it.
Vec2 size_of(const ProgramRoom& wanted, const RoomKind& kind, Random random) {
  const auto usual = [](const brief::Range& range) { return Range{range.low, range.high}; };
  double width = drawn(wanted.width.value_or(usual(kind.width)), random);
  double depth = drawn(wanted.depth.value_or(usual(kind.depth)), random);
  if (wanted.area) {
    const double area = drawn(*wanted.area, random);
    if (wanted.width) depth = area / width;
    else if (wanted.depth) width = area / depth;
    else {
      const double factor = std::sqrt(area / (width * depth));
      width *= factor, depth *= factor;
    }
  }
  return {to_centimetres(width), to_centimetres(depth)};
}

Result<Polygon> outline_of(const ProgramRoom& wanted, const RoomKind& kind, const Random& random) {
  if (wanted.polygon) return *wanted.polygon;
  const Vec2 size = size_of(wanted, kind, random.fork("size"));
  if (size.minCoeff() < least_room_side || size.maxCoeff() > greatest_room_side)
    return Error{Error::Kind::limit, "/room: a room of " + std::to_string(size.x()) + " x " + std::to_string(size.y()) +
                                         " m; sides are 0.5 to 50 m"};
  return make_polygon({{0, 0}, {size.x(), 0}, {size.x(), size.y()}, {0, size.y()}});
}

}  // namespace

Result<Room> room_of(const ConstraintProgram& program, std::uint64_t seed, std::vector<std::string>& notes) {
  const auto& kinds = brief::built_in_room_kinds();
  if (!kinds) return kinds.error();
  RoomKind kind = kinds->get(program.room.type);
  kind.type = program.room.type;
  if (program.room.height) kind.height = *program.room.height;
  const Random random = Random(seed).fork("room");
  auto polygon = outline_of(program.room, kind, random);
  if (!polygon) return polygon.error();
  Random windows = random.fork("windows");
  plan::RoomOpenings openings;
  openings.windows = program.room.openings ? 0 : windows.integer(kind.windows.low, kind.windows.high);
  if (!program.room.openings)
    return plan::make_room(kind, {*polygon, {}, {}}, openings, random.fork("openings"), notes);
  Room room;
  room.type = kind.type;
  room.height = kind.height;
  room.polygon = *polygon;
  room.openings = *program.room.openings;
  plan::ensure_door(room, kind, notes);
  if (auto sound = check(room); !sound) return sound.error();
  return room;
}

}  // namespace roomgen::lab
