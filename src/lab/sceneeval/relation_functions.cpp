#include "relation_functions.h"

#include <functional>
#include <map>
#include <string>

#include "geometric_relations.h"
#include "object_relations.h"
#include "part_of_room.h"
#include "room_relations.h"

namespace roomgen::lab {

namespace {

BoxSide side_named(const std::string& name) {
  if (name == "left") return BoxSide::left;
  if (name == "right") return BoxSide::right;
  if (name == "front") return BoxSide::front;
  if (name == "back") return BoxSide::back;
  if (name == "top") return BoxSide::top;
  return BoxSide::bottom;
}

template <typename Function>
using Functions = std::map<std::string, Function, std::less<>>;

// What a function between two things is given.
struct Pair {
  const Thing& target;
  const Thing& anchor;
  const std::string& parameter;
  std::span<const Thing> walls;  // of the anchor's room
};

const Functions<double (*)(const Pair&)>& pair_functions() {
  using namespace sceneeval;
  static const Functions<double (*)(const Pair&)> all = {
      {"inside_of", [](const Pair& p) { return inside_of(p.target, p.anchor); }},
      {"outside_of", [](const Pair& p) { return outside_of(p.target, p.anchor); }},
      {"face_to", [](const Pair& p) { return face_to(p.target, p.anchor); }},
      {"side_of",
       [](const Pair& p) { return side_of(p.target, p.anchor, side_named(p.parameter)); }},
      {"side_region",
       [](const Pair& p) { return side_region(p.target, p.anchor, side_named(p.parameter)); }},
      {"long_short_side_of",
       [](const Pair& p) { return long_short_side_of(p.target, p.anchor, p.parameter == "long"); }},
      {"on_top", [](const Pair& p) { return on_top(p.target, p.anchor); }},
      {"middle_of", [](const Pair& p) { return middle_of(p.target, p.anchor); }},
      {"next_to", [](const Pair& p) { return next_to(p.target, p.anchor); }},
      {"near", [](const Pair& p) { return near(p.target, p.anchor); }},
      {"across_from", [](const Pair& p) { return across_from(p.target, p.anchor); }},
      {"far", [](const Pair& p) { return far(p.target, p.anchor); }},
      {"behind_on_wall", [](const Pair& p) { return behind_on_wall(p.target, p.anchor, p.walls); }},
      {"stands_in", [](const Pair& p) { return stands_in(p.target, p.anchor); }},
      {"above_sheet", [](const Pair& p) { return above_sheet(p.target, p.anchor, p.walls); }},
      {"under_sheet", [](const Pair& p) { return under_sheet(p.target, p.anchor, p.walls); }},
  };
  return all;
}

const Functions<double (*)(std::span<const Thing>, const Thing&)>& group_functions() {
  static const Functions<double (*)(std::span<const Thing>, const Thing&)> all = {
      {"surround", sceneeval::surround},
      {"between",
       [](std::span<const Thing> ends, const Thing& middle) { return between(middle, ends); }},
  };
  return all;
}

double in_part_of_room(const Thing& thing, const Room& room, const std::string& word) {
  const auto part = RelationWords::built_in().part_of_room(word);
  return part && lies_in(thing.box().center.head<2>(), room, *part) ? 1.0 : 0.0;
}

// What a function of a thing to its room is given.
struct Place {
  const Thing& thing;
  const RoomSurfaces& around;
  std::span<const Thing> parts;  // the doors or windows that the requirement names, else the walls
  const std::string& parameter;
};

const Functions<double (*)(const Place&)>& room_functions() {
  using namespace sceneeval;
  static const Functions<double (*)(const Place&)> all = {
      {"inside_room", [](const Place& p) { return inside_room(p.thing, p.around.room); }},
      {"middle_of_room", [](const Place& p) { return middle_of_room(p.thing, p.around.room); }},
      {"next_to", [](const Place& p) { return next_to(p.thing, p.parts); }},
      {"near", [](const Place& p) { return near(p.thing, p.parts); }},
      {"across_from", [](const Place& p) { return across_from(p.thing, p.parts); }},
      {"far", [](const Place& p) { return far(p.thing, p.parts); }},
      {"on_wall", [](const Place& p) { return on_wall(p.thing, p.around.parts.walls); }},
      {"against_wall", [](const Place& p) { return against_wall(p.thing, p.around.parts.walls); }},
      {"corner_of_room",
       [](const Place& p) { return corner_of_room(p.thing, p.around.parts.walls, p.around.room); }},
      {"hang_from_ceiling",
       [](const Place& p) { return hang_from_ceiling(p.thing, p.around.room); }},
      {"in_part_of_room",
       [](const Place& p) { return in_part_of_room(p.thing, p.around.room, p.parameter); }},
      {"face_wall", [](const Place& p) { return face_wall(p.thing, p.around.parts.walls); }},
      {"face_opening", [](const Place& p) { return face_opening(p.thing, p.parts); }},
      {"on_opening", [](const Place& p) { return on_opening(p.thing, p.parts); }},
      {"beside_opening",
       [](const Place& p) { return beside_opening(p.thing, p.parts, side_named(p.parameter)); }},
      {"on_floor", [](const Place& p) { return on_floor(p.thing); }},
  };
  return all;
}

std::span<const Thing> parts_named(std::string_view part, const RoomThings& parts) {
  return part == "door" ? parts.doors : part == "window" ? parts.windows : parts.walls;
}

}  // namespace

bool is_relation_function(std::string_view name) {
  return pair_functions().contains(name) || group_functions().contains(name) ||
         room_functions().contains(name);
}

double evaluate(const RelationFunction& function, std::span<const Thing> targets,
                const Thing& anchor, const RoomSurfaces& around) {
  const auto group = group_functions().find(function.name);
  if (group != group_functions().end()) return group->second(targets, anchor);
  const auto pair = pair_functions().find(function.name);
  if (pair == pair_functions().end()) return 0.0;
  const Thing& first = targets.front();
  return pair->second({function.reversed ? anchor : first, function.reversed ? first : anchor,
                       function.parameter, around.parts.walls});
}

double evaluate(const RelationFunction& function, const Thing& thing, std::string_view part,
                const RoomSurfaces& around) {
  const auto found = room_functions().find(function.name);
  if (found == room_functions().end()) return 0.0;
  return found->second({thing, around, parts_named(part, around.parts), function.parameter});
}

}  // namespace roomgen::lab
