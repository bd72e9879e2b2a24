#include "support/held.h"

using namespace roomgen;

namespace {

//   ====== ceiling 2.7     [lamp]
//                          on the
//          +------+  0.75  table
//          |table |
Scene with_table() {
  return rooms::scene(rooms::box(6, 6), {rooms::thing("table-0", "table", {1.6, 0.8, 0.75}, {3, 3}, 30)});
}

Object lamp(double bottom, double x = 0.0, double height = 0.4) {
  Object o = rooms::thing("lamp-0", "thing", {0.3, 0.3, height}, {3 + x, 3}, 30);
  o.position.z() = bottom;
  return o;
}

bool is(const std::string& relation, const Object& object) {
  return held(with_table(), object, relation + ", table-0");
}

}  // namespace

TEST_CASE("on: stands on the target, not beside or over it") {
  CHECK(is("on", lamp(0.75)));
  CHECK(is("on", lamp(0.5)));  // on a board inside it
  CHECK_FALSE(is("on", lamp(0.75, 1.2)));
  CHECK_FALSE(is("on", lamp(1.2)));
}

TEST_CASE("inside: within the target, its middle not above the target's top") {
  CHECK(is("inside", lamp(0.1)));
  CHECK(is("inside", lamp(0.54)));  // its middle at 0.74, the target's top at 0.75
  CHECK_FALSE(is("inside", lamp(0.56)));
  CHECK_FALSE(is("inside", lamp(0.75)));
  CHECK_FALSE(is("inside", lamp(0.1, 1.2)));
}

TEST_CASE("above: over the target's top, its centre over the target") {
  CHECK(is("above", lamp(0.75)));
  CHECK(is("above", lamp(2.0)));
  CHECK_FALSE(is("above", lamp(0.7)));
  CHECK_FALSE(is("above", lamp(2.0, 1.2)));
}

TEST_CASE("under: below the target's bottom, and a rug is under what stands on it") {
  Scene shelf = with_table();
  shelf.objects[0].position.z() = 1.4;  // hangs
  CHECK(held(shelf, lamp(0.0, 0.0, 1.4), "under, table-0"));
  CHECK_FALSE(held(shelf, lamp(0.0, 0.0, 1.5), "under, table-0"));
  CHECK_FALSE(held(shelf, lamp(0.0, 1.2, 0.5), "under, table-0"));
  Object rug = rooms::thing("rug-0", "rug", {2.0, 1.4, 0.01}, {3, 3}, 30);
  rug.traits.flat = true;
  CHECK(is("under", rug));
}

TEST_CASE("hang from: under the thing itself, or with the back at the wall that is meant") {
  Scene beam = with_table();
  beam.objects[0].position.z() = 1.9;  // to 2.65
  const auto hangs = [&](double top, double aside = 0.0, Mount mount = Mount::ceiling) {
    Object bulb = lamp(top - 0.4, aside);
    bulb.mount = mount;
    CHECK(held(beam, bulb, "on, table-0") == (held(beam, bulb, "hang from, table-0") && mount == Mount::ceiling));
    return held(beam, bulb, "hang from, table-0");
  };
  CHECK(hangs(1.9));
  CHECK(hangs(2.2));         // on a hook of its side
  CHECK(hangs(2.2, 0, Mount::wall));
  CHECK_FALSE(hangs(2.7));   // at the ceiling over it
  CHECK_FALSE(hangs(1.7));   // in the air
  CHECK_FALSE(hangs(1.9, 1.5));
  CHECK_FALSE(hangs(1.9, 0, Mount::surface));  // stands on something
  beam.objects[0].size.z() = 0.8;  // by its wires up to the ceiling
  CHECK(hangs(1.9));
  CHECK_FALSE(hangs(2.7));
  Object picture = rooms::thing("picture-0", "thing", {0.8, 0.04, 0.6}, {3, 5.97}, 0);
  picture.position.z() = 1.4;
  picture.mount = Mount::wall;
  CHECK(held(with_table(), picture, "hang from, wall-2"));
  CHECK(held(with_table(), picture, "hang from, wall"));
  CHECK_FALSE(held(with_table(), picture, "hang from, wall-1"));
  CHECK_FALSE(is("hang from", picture));
}

TEST_CASE("near and next to a wall mean, of what hangs on one, that wall") {
  Object picture = rooms::thing("picture-0", "thing", {0.8, 0.04, 0.6}, {0.5, 5.97}, 0);
  picture.position.z() = 1.4;
  for (const char* relation : {"near, ", "next to, "}) {
    picture.mount = Mount::wall;
    CHECK(held(with_table(), picture, std::string(relation) + "wall-2"));
    CHECK_FALSE(held(with_table(), picture, std::string(relation) + "wall-3"));
    picture.mount = Mount::floor;
    CHECK(held(with_table(), picture, std::string(relation) + "wall-3"));
  }
}
