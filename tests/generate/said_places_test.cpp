// Where a plan says that things stand, and what becomes of that where there is no room.
#include "catch.h"
#include "roomgen/base/text.h"
#include "roomgen/create/create.h"
#include "roomgen/design/designer.h"
#include "roomgen/generate/generate.h"
#include "small_plans.h"

using namespace roomgen;

namespace {

Generation made(const Plan& plan) {
  const auto designer = make_rule_designer();
  const auto library = create::make_created_library();
  auto room = generate(plan, *designer, *library, KindTable::built_in(), {});
  REQUIRE(room);
  return *std::move(room);
}

double off(const Generation& room, const std::string& id, const Vec2& place) {
  const Object* object = find_object(room.scene, id);
  REQUIRE(object);
  return (object->position.head<2>() - place).norm();
}

}  // namespace

TEST_CASE("A group of which something would be outside is moved by little more than that") {
  for (const double outside : {0.0, 0.004, 0.01, 0.03, 0.12}) {
    INFO(outside);
    const Vec2 desk(4.0 + outside, 2.5);  // the stool ends 1 m to its left
    const Generation room = made(rooms::desk_and_stool(desk, "[0.8, 0]"));
    CHECK(off(room, "desk-0", desk) <= 1.5 * outside + 0.02);
    const Vec2 apart = (find_object(room.scene, "stool-0")->position -
                        find_object(room.scene, "desk-0")->position).head<2>();
    CHECK((apart - Vec2(0.8, 0)).norm() < 0.01);
  }
}

TEST_CASE("A member that overlaps another stands beside its place, and its group where it was said") {
  const Generation room = made(rooms::desk_and_stool({2.5, 2.5}, "[0.75, 0]"));  // 5 cm within the desk's end
  CHECK(off(room, "desk-0", {2.5, 2.5}) < 1e-3);
  CHECK(off(room, "stool-0", {3.25, 2.5}) < 0.1);
}

TEST_CASE("What has a place by the plan keeps it from what has none, and its facing from constraints") {
  PlanItem free = rooms::item("cabinet", Mount::floor, 3), said = rooms::item("cabinet");
  free.size = said.size = Vec3(1.0, 0.5, 1.0);
  said.location = Vec2(2.5, 2.0);
  said.facing = radians(90.0);
  said.relations = {{RelationKind::face_to, "door-0"}};
  const Generation room = made(rooms::plan_of({free, said}, rooms::room_with_door(5, 4)));
  CHECK(off(room, "cabinet-3", {2.5, 2.0}) < 1e-3);
  CHECK(std::abs(wrap_angle(find_object(room.scene, "cabinet-3")->yaw - radians(90.0))) < 0.01);
}

TEST_CASE("What was to stand on a thing that has no room for it is told where it stands") {
  PlanItem low = rooms::item("stool"), table = rooms::item("table"),
           lamp = rooms::item("table lamp", Mount::surface, 4);
  low.size = Vec3(0.3, 0.3, 0.5);
  lamp.size = Vec3(0.25, 0.25, 0.4);
  lamp.asked = true;
  lamp.relations = {{RelationKind::on, "stool-0"}};
  const Generation room = made(rooms::plan_of({low, table, lamp}, rooms::room_with_door(4, 4)));
  int elsewhere = 0;
  for (const auto& object : room.scene.objects)
    if (object.category == "table lamp" && object.on != "stool-0" && ++elsewhere)
      CHECK(std::any_of(room.notes.begin(), room.notes.end(), [&](const std::string& note) {
        return note.find(object.id + " stands on " + object.on) == 0;
      }));
  CHECK(elsewhere > 0);
}
