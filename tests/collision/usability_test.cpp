#include "collision/usability.h"

#include "catch.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

const KindTable& categories() {
  static const KindTable table = *KindTable::parse(R"({"kinds": {
    "chair": {},
    "desk": {"zones": [{"side": "front", "depth": 0.7, "partners": ["chair"]}]},
    "bed": {"zones": [{"side": "left", "depth": 0.6}, {"side": "right", "depth": 0.6}]},
    "plant": {}}})", "test");
  return table;
}

bool usable(const std::vector<Object>& objects, Room room = rooms::box(5, 5)) {
  room.openings = {rooms::door("door-0", 3, 2, 2.9)};
  const auto things = floor_things(objects, categories());
  return is_usable(room, things, things.front(), make_occupancy_grid(room, things));
}

bool free_zone(const std::vector<Object>& objects) {
  const auto things = floor_things(objects, categories());
  return zone_is_free(rooms::box(5, 5), things, things.front(), things.front().category->zones.front());
}

const Object desk = rooms::thing("desk-0", "desk", {1.2, 0.6, 0.75}, {3, 4.6});  // its zone: y 3.6 to 4.3

}  // namespace

TEST_CASE("A zone is free when nothing else stands in it") {
  CHECK(free_zone({desk}));
  CHECK_FALSE(free_zone({desk, rooms::thing("a", "plant", {0.3, 0.3, 0.5}, {3, 4})}));
  CHECK(free_zone({desk, rooms::thing("a", "plant", {0.3, 0.3, 0.5}, {3, 3.4})}));
  // It may reach into it by 20 mm.
  CHECK(free_zone({desk, rooms::thing("a", "plant", {0.3, 0.3, 0.5}, {3, 3.469})}));
  CHECK_FALSE(free_zone({desk, rooms::thing("a", "plant", {0.3, 0.3, 0.5}, {3, 3.475})}));
}

TEST_CASE("Partners, rugs and things overhead or on tables may be in the zone") {
  CHECK(free_zone({desk, rooms::thing("a", "chair", {0.5, 0.5, 0.9}, {3, 4})}));
  Object rug = rooms::thing("a", "plant", {1, 1, 0.02}, {3, 4});
  rug.traits.flat = true;
  CHECK(free_zone({desk, rug}));
  Object lamp = rooms::thing("a", "plant", {1, 1, 0.5}, {3, 4});
  lamp.position.z() = 1.8;
  CHECK(free_zone({desk, lamp}));
  lamp.position.z() = 1.7;
  CHECK_FALSE(free_zone({desk, lamp}));
  Object on_table = rooms::thing("a", "plant", {0.3, 0.3, 0.3}, {3, 4});
  on_table.mount = Mount::surface;
  CHECK(free_zone({desk, on_table}));
  Object shelf = rooms::thing("a", "plant", {1, 0.3, 0.3}, {3, 4});
  shelf.mount = Mount::wall;
  shelf.position.z() = 1.3;
  CHECK(free_zone({desk, shelf}));
  shelf.position.z() = 1.1;
  CHECK_FALSE(free_zone({desk, shelf}));
}

TEST_CASE("A zone must lie in the room") {
  CHECK_FALSE(free_zone({rooms::thing("desk-0", "desk", {1.2, 0.6, 0.75}, {3, 0.9})}));
  CHECK(free_zone({rooms::thing("desk-0", "desk", {1.2, 0.6, 0.75}, {3, 1.0})}));
}

TEST_CASE("One zone of several is enough") {
  //  The bed's left side (+X) is at the wall, then both are blocked.
  const Object bed = rooms::thing("bed-0", "bed", {1.6, 2, 0.5}, {4.19, 3.9});
  CHECK(usable({bed}));
  CHECK_FALSE(usable({bed, rooms::thing("a", "plant", {0.3, 0.3, 0.5}, {3.1, 4})}));
}

TEST_CASE("A free zone that nobody can walk to is no use") {
  //  D           |  desk
  //              |  (walled in)
  const auto wall = [](double gap) {
    return rooms::thing("a", "plant", {0.2, 5 - gap, 1}, {2, 5 - 0.5 * (5 - gap)});
  };
  CHECK(usable({desk, wall(0.7)}));
  CHECK_FALSE(usable({desk, wall(0.4)}));
}

TEST_CASE("Things without zones, on others or hanging are always usable") {
  const Object wall = rooms::thing("a", "chair", {0.2, 5, 1}, {2, 2.5});
  CHECK(usable({rooms::thing("p", "plant", {0.3, 0.3, 1}, {4, 4}), wall}));
  Object lamp = desk;
  lamp.mount = Mount::surface;
  CHECK(usable({lamp, wall}));
  lamp.mount = Mount::wall;
  CHECK(usable({lamp, wall}));
}
