#include "roomgen/evaluate/report.h"

#include <algorithm>

#include "catch.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

//  +----window-0----+     4 x 4 m
//  |                |
//  |                |
//  +-door-0---------+
Room plain_room() {
  Room room = rooms::box(4, 4);
  room.openings = {rooms::door("door-0", 0, 0.4, 1.3), rooms::window("window-0", 2, 1, 3)};
  return room;
}

std::vector<std::string> faults(std::vector<Object> objects, Room room = plain_room()) {
  std::vector<std::string> found;
  const auto report = examine(rooms::scene(std::move(room), std::move(objects)), ModelTable(),
                              KindTable::built_in());
  for (const auto& v : report.violations)
    found.push_back(std::string(name(v.fault)) + " " + v.object + " " + v.other);
  return found;
}

using Faults = std::vector<std::string>;

Object cube(const std::string& id, double x, double y, double size = 0.6, double height = 0.6) {
  return rooms::thing(id, "thing", {size, size, height}, {x, y});
}

}  // namespace

TEST_CASE("An empty room and a sound one have no faults") {
  CHECK(faults({}).empty());
  CHECK(faults({cube("a-0", 2, 2), cube("b-0", 3.7, 0.3)}).empty());
}

TEST_CASE("outside: through a wall, through the ceiling, under the floor, or not in the room at all") {
  CHECK(faults({cube("a-0", 0.298, 2)}) == Faults{"outside a-0 "});
  CHECK(faults({cube("a-0", 0.2995, 2)}).empty());
  CHECK(faults({cube("a-0", 2, 2, 0.6, 2.702)}) == Faults{"outside a-0 "});
  CHECK(faults({cube("a-0", 2, 2, 0.6, 2.7)}).empty());
  CHECK(faults({cube("a-0", 20, 20)}) == Faults{"outside a-0 "});
  Object sunk = cube("a-0", 2, 2);
  sunk.position.z() = -0.1;
  CHECK(faults({sunk}) == Faults{"outside a-0 "});
}

TEST_CASE("overlap: each pair once, not for rugs nor one over the other") {
  CHECK(faults({cube("a-0", 2, 2), cube("b-0", 2.4, 2)}) == Faults{"overlap b-0 a-0"});
  CHECK(faults({cube("a-0", 2, 2), cube("b-0", 2.6, 2)}).empty());
  CHECK(faults({cube("a-0", 2, 2, 1.0, 1.0), cube("b-0", 2, 2, 0.2, 0.2)}) == Faults{"overlap b-0 a-0"});
  Object rug = cube("rug-0", 2, 2, 1.5, 0.01);
  rug.traits.flat = true;
  CHECK(faults({rug, cube("b-0", 2.4, 2)}).empty());
  Object lamp = cube("lamp-0", 2, 2);
  lamp.position.z() = 0.6;
  CHECK(faults({cube("a-0", 2, 2), lamp}).empty());
}

TEST_CASE("blocks door: low things too, in the whole approach and no further") {
  CHECK(faults({cube("a-0", 0.85, 1.19, 0.6, 0.1)}) == Faults{"blocks door a-0 door-0"});
  CHECK(faults({cube("a-0", 0.85, 1.201)}).empty());
  CHECK(faults({cube("a-0", 1.601, 0.301)}).empty());
  Object shelf = cube("a-0", 0.85, 0.4);
  shelf.position.z() = 2.05;  // over the door
  CHECK(faults({shelf}).empty());
  Object rug = cube("rug-0", 0.85, 0.5);
  rug.traits.flat = true;
  CHECK(faults({rug}).empty());
}

TEST_CASE("blocks window: what reaches over the sill by more than 0.1 m") {
  CHECK(faults({cube("a-0", 2, 3.5, 0.6, 1.0)}).empty());
  CHECK(faults({cube("a-0", 2, 3.5, 0.6, 1.05)}) == Faults{"blocks window a-0 window-0"});
  CHECK(faults({cube("a-0", 2, 3.19, 0.6, 1.05)}).empty());  // 0.51 m before it
  CHECK(faults({cube("a-0", 0.65, 3.65, 0.6, 2.0)}).empty());
}

TEST_CASE("unusable: no room to use it, or nobody gets there") {
  const Object desk = rooms::thing("desk-0", "desk", {1.2, 0.6, 0.75}, {3, 3.1});
  CHECK(faults({desk}).empty());
  // The front to the wall.
  CHECK(faults({rooms::thing("desk-0", "desk", {1.2, 0.6, 0.75}, {3, 0.31})}) ==
        Faults{"unusable desk-0 "});
  // A thing in the zone, and a partner there instead.
  const Object thing = rooms::thing("a-0", "thing", {1.0, 0.5, 0.5}, {3, 2.5});
  CHECK(faults({desk, thing}) == Faults{"unusable desk-0 "});
  const Object chair = rooms::thing("chair-0", "chair", {0.5, 0.5, 0.9}, {3, 2.5}, 180);
  CHECK(faults({desk, chair}).empty());
  // The zone is free but walled in.
  CHECK(faults({desk, rooms::thing("a-0", "thing", {2.2, 0.2, 0.5}, {2.9, 1.9}),
                rooms::thing("b-0", "thing", {0.2, 1.9, 0.5}, {1.9, 3.04})}) ==
        Faults{"unusable desk-0 "});
}

TEST_CASE("doors not connected: a wall of things between two doors") {
  Room room = rooms::box(6, 3);
  room.openings = {rooms::door("door-0", 3, 1, 1.9), rooms::door("door-1", 1, 1, 1.9)};
  const auto wall = [](double gap) {
    return rooms::thing("shelf-0", "thing", {0.3, 3.0 - gap - 0.002, 1.8}, {3, 0.5 * (3.0 - gap)});
  };
  CHECK(faults({wall(0.6)}, room).empty());
  CHECK(faults({wall(0.4)}, room) == Faults{"doors not connected  "});
}

TEST_CASE("The verdicts on all relations come in order, and those that hold are counted") {
  Object bed = rooms::thing("bed-0", "thing", {1.6, 2, 0.5}, {3.1, 2.99});
  bed.relations = *parse_relations("edge | middle");
  Object lamp = rooms::thing("lamp-0", "thing", {0.3, 0.3, 1.5}, {2, 2});
  lamp.relations = *parse_relations("near, bed-0 | far, bed-0 | near, gone-0");
  const auto report = examine(rooms::scene(plain_room(), {bed, lamp}), ModelTable(),
                              KindTable::built_in());
  std::string verdicts;
  for (const auto& verdict : report.relations)
    verdicts += verdict.object + ": " + to_text(verdict.relation) +
                (verdict.judgement.held ? " yes\n" : " no\n");
  CHECK(verdicts ==
        "bed-0: edge yes\nbed-0: middle no\nlamp-0: near, bed-0 yes\nlamp-0: far, bed-0 no\n"
        "lamp-0: near, gone-0 no\n");
  CHECK(report.relations_held() == 2);
}

TEST_CASE("Overlaps are looked for until there are 200, and what comes after that is named") {
  const Room room = rooms::box(30, 30);
  std::vector<Object> objects;
  const auto pile = [&](int count, double x) {
    for (int i = 0; i < count; ++i) objects.push_back(cube("c-" + std::to_string(objects.size()), x, 5));
  };
  pile(20, 5);   // 190 pairs
  pile(5, 10);   // 10 more
  CHECK(faults(objects, room).size() == 200);
  pile(3, 15);
  const auto found = faults(objects, room);
  REQUIRE(found.size() == 201);
  CHECK(found.back() == "too crowded to look for overlaps from here on c-26 ");
  CHECK(std::count_if(found.begin(), found.end(), [](const auto& text) { return text.starts_with("overlap "); }) == 200);
}

TEST_CASE("Things that overlap by their boxes only are looked at 10,000 times") {
  // Each cylinder stands in the corners of four others' boxes.
  std::vector<Object> objects;
  for (int i = 0; i < 70; ++i)
    for (int j = 0; j < 73; ++j) {
      objects.push_back(rooms::thing("c-" + std::to_string(objects.size()), "thing", {1, 1, 1},
                                     {1 + 0.8 * (i + j), 60 + 0.8 * (i - j)}));
      objects.back().traits.round = true;
    }
  const auto of_pairs = [&](std::size_t count) {
    const auto found = faults({objects.begin(), objects.begin() + static_cast<std::ptrdiff_t>(count)}, rooms::box(119, 121));
    return std::count_if(found.begin(), found.end(), [](const auto& text) { return text.starts_with("too crowded"); });
  };
  CHECK(of_pairs(69 * 73) == 0);  // 2 * 69 * 73 - 69 - 73 = 9,932
  CHECK(of_pairs(70 * 73) == 1);  // 10,077
}
