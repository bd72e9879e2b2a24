#include "base/random.h"
#include "catch.h"
#include "lab/sceneeval/geometric_relations.h"
#include "roomgen/lab/scores.h"
#include "support/rooms.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

Thing at(const Vec3& size, const Vec2& place, double yaw = 0.0, double height = 0.0) {
  Object object = rooms::thing("a-0", "thing", size, place, yaw);
  object.position.z() = height;
  return thing_of(object, ModelTable());
}

double between(const Thing& middle, const Thing& a, const Thing& b) {
  return between(middle, std::vector{a, b});
}

}  // namespace

TEST_CASE("A table between a sofa and a console, and beside them") {
  const Thing sofa = at({2, 0.9, 0.8}, {0, 0}), console = at({1.5, 0.4, 0.5}, {0, 3});
  const Vec3 table(1, 0.6, 0.4);
  CHECK(between(at(table, {0, 1.5}), sofa, console) == 1.0);
  CHECK(between(at(table, {0, 1.5}), console, sofa) == 1.0);
  CHECK(between(at(table, {1.4, 1.5}), sofa, console) == 1.0);  // its side still in the corridor
  CHECK(between(at(table, {1.6, 1.5}), sofa, console) == 0.0);
  CHECK(between(at(table, {0, -1}), sofa, console) == 0.0);           // behind the sofa
  CHECK(between(at(table, {0, 3.5}), sofa, console) == 0.0);          // beyond the console
  CHECK(between(at(table, {0, 0.2}, 0, 0.8), sofa, console) == 0.0);  // on the sofa
  CHECK(between(at(table, {0, 1.5}), std::vector{sofa}) == 0.0);
}

TEST_CASE("A sconce between two mirrors on a wall") {
  const Vec3 mirror(0.6, 0.04, 0.8), sconce(0.18, 0.17, 0.32);
  const Thing left = at(mirror, {1, 0.02}, 180, 1.2), right = at(mirror, {2.2, 0.02}, 180, 1.2);
  CHECK(between(at(sconce, {1.6, 0.085}, 180, 1.5), left, right) == 1.0);
  CHECK(between(at(sconce, {2.9, 0.085}, 180, 1.5), left, right) == 0.0);
  CHECK(between(at(sconce, {1.6, 2.9}, 0, 1.5), left, right) == 0.0);  // on the wall opposite
}

TEST_CASE("Between agrees with corners and angles, whatever way the things are turned") {
  Random random(3);
  int held = 0;
  for (int i = 0; i < 500; ++i) {
    Object things[3];
    for (auto& thing : things) {
      Vec3 size;
      for (int axis = 0; axis < 3; ++axis) size[axis] = random.uniform(0.2, 1.5);
      const double x = random.uniform(-2, 2);
      const double y = random.uniform(-2, 2);
      thing = rooms::thing("a-0", "thing", size, {x, y}, random.uniform(-180, 180));
    }
    const auto corners = [](const Object& object) {
      std::vector<Vec2> points;
      for (const double sx : {-0.5, 0.5})
        for (const double sy : {-0.5, 0.5})
          points.push_back(object.position.head<2>() +
                           rotated({sx * object.size.x(), sy * object.size.y()}, object.yaw));
      return points;
    };
    const Vec2 m = things[0].position.head<2>(), a = things[1].position.head<2>(),
               b = things[2].position.head<2>();
    const auto spread =
        [&](const Object& object) {  // the distance of the corners from the line's direction
          double most = 0.0;
          for (const auto& corner : corners(object))
            most = std::max(most, std::abs(cross(b - a, corner - Vec2(object.position.head<2>()))) /
                                      (b - a).norm());
          return most;
        };
    const auto over = [&](const Object& object) {
      const Vec2 local = rotated(m - Vec2(object.position.head<2>()), -object.yaw).cwiseAbs();
      return local.x() <= 0.5 * object.size.x() && local.y() <= 0.5 * object.size.y();
    };
    // Both angles at the ends are acute: the foot of the perpendicular lies between them.
    const bool expected = (m - a).dot(b - a) > 0 && (m - b).dot(a - b) > 0 && !over(things[1]) &&
                          !over(things[2]) &&
                          std::abs(cross(b - a, m - a)) / (b - a).norm() <=
                              std::max(spread(things[1]), spread(things[2])) + spread(things[0]);
    const auto thing = [](const Object& object) { return thing_of(object, ModelTable()); };
    CHECK(between(thing(things[0]), thing(things[1]), thing(things[2])) == (expected ? 1.0 : 0.0));
    held += expected;
  }
  CHECK(held > 50);
  CHECK(held < 450);
}

TEST_CASE("What is between several things of a kind is one") {
  const auto rows = parse_requirements(
      "ID,Description,ObjCount,OORel\n1,x,\"eq,1,lamp\","
      "\"eq,1,between,0,lamp,shelf,shelf;eq,2,between,0,lamp,shelf,shelf;"
      "eq,1,between,0,lamp,shelf,desk\"\n",
      "r");
  REQUIRE(rows);
  Scene scene =
      rooms::scene(rooms::box(6, 6), {rooms::thing("lamp-0", "lamp", {0.3, 0.3, 1.5}, {3, 3})});
  for (int k = 0; k < 4; ++k)  // one at each side, so that the lamp is between two pairs
    scene.objects.push_back(rooms::thing("shelf-" + std::to_string(k), "shelf", {1, 0.3, 1.8},
                                         Vec2(3, 3) + 2 * rotated({1, 0}, 0.5 * k * pi)));
  const auto verdicts = score_room(rows->front(), scene, ModelTable()).object_relations;
  CHECK(verdicts[0].satisfied);
  CHECK_FALSE(verdicts[1].satisfied);
  CHECK(verdicts[2].missing == "desk");
}
