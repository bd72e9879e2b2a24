#include "catch.h"
#include "evaluate/clauses.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

Compliance judged(const Room& room, const char* what, double amount, const char* category = "",
                  bool at_least = false) {
  Requirement requirement;
  requirement.kind = Requirement::Kind::room;
  requirement.attribute = what;
  requirement.amount = amount;
  requirement.category = category;
  requirement.at_least = at_least;
  return judge_room(requirement, room).compliance;
}

}  // namespace

TEST_CASE("The sides, the height and the area of a room are measured") {
  Room room = rooms::box(3, 5);
  room.height = 2.9;
  CHECK(judged(room, "longer side", 5.0) == Compliance::met);
  CHECK(judged(room, "longer side", 5.04) == Compliance::met);
  CHECK(judged(room, "longer side", 4.5) == Compliance::not_met);
  CHECK(judged(room, "shorter side", 3.0) == Compliance::met);
  CHECK(judged(room, "height", 2.7) == Compliance::not_met);
  CHECK(judged(room, "area", 15.5) == Compliance::met);
  CHECK(judged(room, "area", 20.0) == Compliance::not_met);
  CHECK(judged(room, "proportion", 1.5) == Compliance::met);
  CHECK(judged(room, "proportion", 2.0) == Compliance::not_met);
  CHECK(judged(room, "scent", 1.0) == Compliance::not_judged);
}

TEST_CASE("The shape of a room is told by its corners") {
  Room room = rooms::box(4, 4);
  CHECK(judged(room, "shape", 0, "rectangle") == Compliance::met);
  CHECK(judged(room, "shape", 0, "L") == Compliance::not_met);
  room.polygon.points = {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
  CHECK(judged(room, "shape", 0, "L") == Compliance::met);
  // A point on a straight wall is no corner.
  room.polygon.points = {{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}};
  CHECK(judged(room, "shape", 0, "rectangle") == Compliance::met);
  CHECK(judged(room, "shape", 0, "pentagon") == Compliance::not_met);
}

TEST_CASE("Openings are counted by their kind or type") {
  Room room = rooms::box(4, 4);
  room.openings.clear();
  CHECK(judged(room, "openings", 0, "window") == Compliance::met);
  Opening window;
  window.type = OpeningType::window;
  window.kind = "bay window";
  room.openings = {window, window};
  CHECK(judged(room, "openings", 2, "window") == Compliance::met);
  CHECK(judged(room, "openings", 1, "window") == Compliance::not_met);
  CHECK(judged(room, "openings", 1, "window", true) == Compliance::met);
  CHECK(judged(room, "openings", 2, "bay window") == Compliance::met);
  CHECK(judged(room, "openings", 1, "door", true) == Compliance::not_met);
}
