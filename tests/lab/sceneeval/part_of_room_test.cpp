// Parts of rooms by their names, and where they are.
#include "lab/sceneeval/part_of_room.h"

#include "base/random.h"
#include "catch.h"
#include "lab/sceneeval/relation_words.h"
#include "roomgen/lab/scores.h"
#include "support/rooms.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

// Six by four, entered through `wall`: 0 in the south, 1 in the east, 2 in the north, 3 in the
// west.
Room entered_at(std::size_t wall) {
  Room room = rooms::box(6, 4);
  room.openings = {rooms::window("window-0", (wall + 1) % 4, 1, 2),
                   rooms::door("door-0", wall, 0.5, 1.4)};
  return room;
}

bool in(const std::string& word, const Vec2& point, const Room& room) {
  const auto part = RelationWords::built_in().part_of_room(word);
  REQUIRE(part);
  return lies_in(point, room, *part);
}

}  // namespace

TEST_CASE("Parts of a room by compass do not ask for the door") {
  Random random(1);
  for (int i = 0; i < 400; ++i) {
    const Room room = entered_at(static_cast<std::size_t>(i) % 4);
    const double x = random.uniform(0, 6);
    const Vec2 p(x, random.uniform(0, 4));
    CHECK(in("northern_half", p, room) == (p.y() >= 2));
    CHECK(in("southern_part", p, room) == (p.y() <= 2));
    CHECK(in("western_third", p, room) == (p.x() <= 2));
    CHECK(in("eastern_quarter", p, room) == (p.x() >= 4.5));
    CHECK(in("north_east_quarter", p, room) == (p.x() >= 3 && p.y() >= 2));
    CHECK(in("southwest_quarter", p, room) == (p.x() <= 3 && p.y() <= 2));
  }
}

TEST_CASE("Front, rear, left and right are those of who comes in") {
  Random random(2);
  for (int i = 0; i < 400; ++i) {
    const std::size_t wall = static_cast<std::size_t>(i) % 4;
    const Room room = entered_at(wall);
    const double x = random.uniform(0, 6);
    const Vec2 p(x, random.uniform(0, 4));
    // How deep in the room, and how far to the right, in parts of it.
    const double deep[] = {p.y() / 4, 1 - p.x() / 6, 1 - p.y() / 4, p.x() / 6};
    const double right[] = {p.x() / 6, p.y() / 4, 1 - p.x() / 6, 1 - p.y() / 4};
    CHECK(in("rear_third", p, room) == (deep[wall] >= 2.0 / 3));
    CHECK(in("front_part", p, room) == (deep[wall] <= 0.5));
    CHECK(in("middle_third", p, room) == (std::abs(deep[wall] - 0.5) <= 1.0 / 6));
    CHECK(in("left_half", p, room) == (right[wall] <= 0.5));
    CHECK(in("right_third", p, room) == (right[wall] >= 2.0 / 3));
  }
}

TEST_CASE("The entrance is the door that leads outdoors, and turns with the room") {
  Room room = entered_at(0);
  room.openings[1].leads_to = "hallway-0";
  room.openings.push_back(rooms::door("door-1", 3, 1, 2));
  CHECK(in("rear_half", {5, 1}, room));
  CHECK_FALSE(in("rear_half", {1, 3}, room));
  for (const double angle : {0.3, 1.0, 2.5}) {
    const Room turned = rooms::moved(room, angle, {7, -2});
    CHECK(in("rear_half", rooms::moved(Vec2(5, 1), angle, {7, -2}), turned));
    CHECK_FALSE(in("rear_half", rooms::moved(Vec2(1, 3), angle, {7, -2}), turned));
  }
  room.openings.clear();
  CHECK(in("rear_half", {1, 3}, room));  // as if entered from the south
}

TEST_CASE("What is outside the room is in no part of it, and other words name none") {
  const Room room = entered_at(0);
  CHECK_FALSE(in("northern_half", {3, 4.2}, room));
  for (const auto* word :
       {"north", "half", "half_north", "upper_half", "northern", "northern_half_wall"})
    CHECK_FALSE(RelationWords::built_in().part_of_room(word));
}

TEST_CASE("Rows may ask for parts of the room, by whatever name the room goes") {
  const auto rows = parse_requirements(
      "ID,Description,ObjCount,OARel\n1,x,\"eq,2,desk\",\"eq,1,northern_half,desk,room;"
      "eq,2,northern_half,desk,room;eq,1,rear_third,desk,main_room;eq,1,northern_half,desk,"
      "wall\"\n",
      "r");
  REQUIRE(rows);
  const Scene scene =
      rooms::scene(entered_at(0), {rooms::thing("desk-0", "desk", {1.2, 0.6, 0.75}, {2, 3.5}),
                                   rooms::thing("desk-1", "desk", {1.2, 0.6, 0.75}, {2, 1.9})});
  const auto verdicts = score_room(rows->front(), scene, ModelTable()).room_relations;
  CHECK(verdicts[0].satisfied);
  CHECK_FALSE(verdicts[1].satisfied);
  CHECK(verdicts[2].satisfied);
  CHECK(verdicts[3].reason.find("means nothing here") != std::string::npos);
}
