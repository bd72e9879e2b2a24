// Shapes of floors: the words for them, and the rooms that come of them.
#include <set>

#include "brief/floor_shapes.h"
#include "brief/outline.h"
#include "brief/prompt.h"
#include "brief/room_kinds.h"
#include "catch.h"
#include "plan/floor_plan.h"
#include "scene/wall_sides.h"
#include "plans.h"

using namespace roomgen;
using namespace roomgen::brief;
using namespace roomgen::plan;
using roomgen::test::plan_of;

namespace {

const FloorShapes& shapes() {
  return *built_in_floor_shapes();
}

SaidShape said_in(const std::string& prompt) {
  return read_prompt(prompt, *built_in_room_kinds(), KindTable::built_in()).shape;
}

// Of the triangle fan, without the library's own formula.
double shoelace(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += cross(polygon.points[i] - polygon.points[0], polygon.points[i + 1] - polygon.points[0]);
  return 0.5 * twice;
}

}  // namespace

TEST_CASE("The outlines of the data are sound whatever is drawn for them") {
  REQUIRE(built_in_floor_shapes());
  Random random(1);
  for (const auto& [name, kind] : shapes().outlines)
    for (int n = 0; n < 60; ++n) {
      INFO(name << " " << n);
      SaidShape said;
      said.outline = name;
      const Vec2 box(random.uniform(3, 9), random.uniform(3, 9));
      const Outline boxed = make_outline(said, shapes(), {box, std::nullopt}, random.fork("a"));
      CHECK(make_polygon(boxed.polygon.points));
      CHECK((bounds(boxed.polygon).size() - box).norm() == Approx(0.0).margin(1e-9));
      CHECK(bounds(boxed.polygon).low.norm() == Approx(0.0).margin(1e-9));
      const double wanted = random.uniform(9, 60);
      const Outline sized = make_outline(said, shapes(), {box, wanted}, random.fork("b"));
      CHECK(shoelace(sized.polygon) == Approx(wanted));
      // Counter-clockwise, so that the inside is to the left of every wall.
      CHECK(signed_area(sized.polygon.points) > 0);
    }
}

TEST_CASE("Bays and alcoves break one wall each and keep the area") {
  Random random(2);
  for (const auto& [name, kind] : shapes().features)
    for (const auto& [outline, unused] : shapes().outlines) {
      INFO(name << " in " << outline);
      SaidShape plain;
      plain.outline = outline;
      SaidShape said = plain;
      said.features = {name};
      const OutlineSize size{{7, 6}, 34.0};
      const Random same = random.fork(name + outline);
      const Outline made = make_outline(said, shapes(), size, same);
      CHECK(make_polygon(made.polygon.points));
      CHECK(shoelace(made.polygon) == Approx(34.0));
      const std::size_t more =
          made.missing.empty() ? (kind.cut.empty() ? kind.along.size() : 1) : 0;
      CHECK(made.polygon.size() == make_outline(plain, shapes(), size, same).polygon.size() + more);
      CHECK(made.glazed.size() == (made.missing.empty() ? kind.glazed.size() : 0));
    }
}

TEST_CASE("A feature that no wall is long enough for is told of") {
  SaidShape said;
  said.features = {"bay", "alcove"};
  const Outline small = make_outline(said, shapes(), {{2.0, 1.8}, std::nullopt}, Random(3));
  CHECK(small.missing == said.features);
  CHECK(small.polygon.size() == 4);
  const Plan plan = plan_of("a bathroom of 2 by 1.8 m with a bay window");
  CHECK(plan.room.polygon.size() == 4);
  CHECK(std::any_of(plan.notes.begin(), plan.notes.end(), [](const std::string& note) {
    return note.find("bay") != std::string::npos;
  }));
}

TEST_CASE("Words for the shape of a room") {
  const std::vector<std::pair<std::string, std::string>> outlines = {
      {"an L-shaped living room", "L"},
      {"a cosy, L-shaped home office with a desk", "L"},
      {"The bedroom is U-shaped and has two beds.", "U"},
      {"a T shaped kitchen", "T"},
      {"a large hexagonal library", "hexagon"},
      {"The room is octagonal. It has a piano.", "octagon"},
      {"a round dining room with a round table", "circle"},
      {"a circular space with a sofa", "circle"},
      {"a trapezoid bedroom", "trapezoid"},
      {"a living room with an L-shaped sofa", ""},
      {"an L-shaped desk in a study", ""},
      {"a dining room with a round table and a hexagonal rug", ""},
      {"a round coffee table in a living room", ""},
      {"a bedroom with an octagonal mirror", ""}};
  for (const auto& [prompt, outline] : outlines) {
    INFO(prompt);
    CHECK(said_in(prompt).outline == outline);
  }
  CHECK(said_in("a bedroom with a bay window").features == std::vector<std::string>{"bay"});
  CHECK(said_in("a bed in the alcove of a bedroom").features == std::vector<std::string>{"alcove"});
  CHECK(said_in("a study with two alcoves").features.size() == 2);
  CHECK(said_in("a study without an alcove").features.empty());
  CHECK(said_in("an attic bedroom with a slanted wall").features ==
        std::vector<std::string>{"slanted wall"});
  CHECK(said_in("a long, narrow kitchen").proportion);
  CHECK_FALSE(said_in("a kitchen with a long table and a narrow shelf").proportion);
}

TEST_CASE("The shape does not take the room or its things from the prompt") {
  for (const std::string prompt : {"an L-shaped living room with a piano", "a hexagonal bedroom with a piano",
                                   "a room that is round with a piano and a bed"}) {
    INFO(prompt);
    const Plan plan = plan_of(prompt);
    CHECK(plan.room.polygon.size() > 4);
    CHECK(test::count_of(plan, "piano") == 1);
  }
  CHECK(plan_of("an L-shaped living room").room.type == "living room");
}

TEST_CASE("Sizes in the prompt are those of the box or of the floor") {
  for (const std::string shape : {"L-shaped", "hexagonal", "round", "trapezoid", "U-shaped"}) {
    INFO(shape);
    const Room boxed = plan_of("a " + shape + " study, 6 x 5 m").room;
    CHECK((bounds(boxed.polygon).size() - Vec2(6, 5)).norm() == Approx(0.0).margin(1e-9));
    const Room sized = plan_of("a " + shape + " study of 24 m2").room;
    CHECK(area(sized.polygon) == Approx(24.0));
  }
  const Vec2 square = bounds(plan_of("a square bedroom of 16 m2").room.polygon).size();
  CHECK(square.x() == Approx(4.0));
  CHECK(square.y() == Approx(4.0));
  const Vec2 narrow = bounds(plan_of("a narrow kitchen of 12 m2").room.polygon).size();
  CHECK(narrow.maxCoeff() / narrow.minCoeff() > 1.7);
}

TEST_CASE("Rooms of every shape have a door that can be entered and windows in their walls") {
  const char* const prompts[] = {"an L-shaped living room", "a T-shaped office", "a U-shaped lounge",
                                 "a hexagonal study", "an octagonal library", "a round bedroom",
                                 "a trapezoid dining room", "a triangular study", "a cross-shaped lobby",
                                 "a bedroom with a bay window", "a bedroom with an alcove",
                                 "an L-shaped living room with a bay window and a slanted wall"};
  for (const std::string prompt : prompts)
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      INFO(prompt << " " << seed);
      const Plan plan = plan_of(prompt, seed);
      const Room& room = plan.room;
      CHECK(check(room));
      int doors = 0, windows = 0;
      for (const auto& opening : room.openings) {
        if (opening.is_entrance()) {
          ++doors;
          CHECK(contains(room.polygon, door_clearance(room, opening)));
          CHECK(opening.width() > 0.6);
        } else {
          ++windows;
        }
      }
      CHECK(doors == 1);
      CHECK(windows <= 5);
      CHECK(plan.items.size() >= 3);
    }
}

TEST_CASE("The walls of a prompt's sides") {
  Polygon box;
  box.points = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  for (std::size_t side = 0; side < 4; ++side) CHECK(wall_on_side(box, side) == side);
  // Told from another corner, sides are the same.
  box.points = {{4, 3}, {0, 3}, {0, 0}, {4, 0}};
  for (std::size_t side = 0; side < 4; ++side) {
    const Vec2 outward[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    CHECK(-box.inward(wall_on_side(box, side)).dot(outward[side]) == Approx(1.0));
  }
  // The longest of those that look there.
  Polygon l;
  l.points = {{0, 0}, {5, 0}, {5, 2}, {2, 2}, {2, 4}, {0, 4}};
  CHECK(wall_on_side(l, 2) == 2);
  CHECK(wall_on_side(l, 3) == 5);
}
