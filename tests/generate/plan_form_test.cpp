// What a plan can say, made by generate() without the command line.
#include <algorithm>
#include <cmath>
#include <map>

#include "catch.h"
#include "roomgen/create/create.h"
#include "roomgen/design/designer.h"
#include "roomgen/generate/generate.h"
#include "small_plans.h"
#include "support/contains.h"

using namespace roomgen;

namespace {

Generation made(const Plan& plan) {
  const auto designer = make_rule_designer();
  const auto library = create::make_created_library();
  auto generation = generate(plan, *designer, *library, KindTable::built_in());
  REQUIRE(generation);
  return *std::move(generation);
}

}  // namespace

TEST_CASE("Openings that a plan wants are in the room, and what cannot be is told") {
  Plan plan = rooms::plan_of({rooms::item("chair")}, rooms::box(5, 4));
  WantedOpening door, window;
  door.kind = "door";
  door.at = 0.5;
  door.wall = "south";
  window.kind = "window";
  window.at = 0.0;  // beyond the corner
  window.wall = "east";
  plan.openings = {door, window};
  const Generation generation = made(plan);
  REQUIRE(generation.scene.room.openings.size() == 1);
  CHECK(generation.scene.room.openings[0].from > 2.0);
  REQUIRE(generation.notes.size() == 1);
  CHECK(contains_text(generation.notes[0], "/openings/1"));
}

TEST_CASE("Things hang as high as they are told to, on a wall and from the ceiling") {
  PlanItem picture = rooms::item("picture", Mount::wall), lamp = rooms::item("pendant lamp", Mount::ceiling),
           clock = rooms::item("wall clock", Mount::wall);
  picture.bottom = 1.25;
  clock.height = 1.9;
  lamp.bottom = 1.7;
  const Generation generation = made(rooms::plan_of({picture, clock, lamp}, rooms::room_with_door(4, 4)));
  REQUIRE(generation.scene.objects.size() == 3);
  const auto& objects = generation.scene.objects;
  CHECK(bottom(objects[0]) == Approx(1.25).margin(1e-3));
  CHECK(0.5 * (bottom(objects[1]) + top(objects[1])) == Approx(1.9).margin(1e-3));
  CHECK(bottom(objects[2]) == Approx(1.7).margin(0.01));
  CHECK(top(objects[2]) == Approx(generation.scene.room.height).margin(0.01));
}

TEST_CASE("What leans has the box of the leaning mesh, its top at the wall and its foot before it") {
  PlanItem upright = rooms::item("mirror"), leaning = upright;
  upright.relations = leaning.relations = {{RelationKind::edge, ""}};
  leaning.tilt = {-radians(10), 0};
  const Object flat = made(rooms::plan_of({upright}, rooms::room_with_door(4, 4))).scene.objects.at(0);
  const Generation generation = made(rooms::plan_of({leaning}, rooms::room_with_door(4, 4)));
  const Object& object = generation.scene.objects.at(0);
  const double s = std::sin(radians(10)), c = std::cos(radians(10));
  CHECK(object.size.z() <= c * flat.size.z() + s * flat.size.y() + 1e-3);
  CHECK(object.size.y() > 0.9 * s * flat.size.z());
  CHECK(bottom(object) == Approx(0.0).margin(1e-6));
  const auto model = generation.models.find(asset_key(object.asset));
  REQUIRE(model);
  CHECK(bounds(*model).size().isApprox(object.size, 1e-3));
  // What is highest is at the back, what is lowest at the front.
  const Mesh mesh = merged_mesh(*model);
  const auto [low, high] = std::minmax_element(mesh.positions.begin(), mesh.positions.end(),
                                               [](const auto& a, const auto& b) { return a.z() < b.z(); });
  CHECK(high->y() > low->y() + 0.5 * object.size.y());
}

TEST_CASE("Two on each table are two on every one, and what dresses comes last") {
  PlanItem vase = rooms::item("vase", Mount::surface, 2), table = rooms::item("table", Mount::floor, 2);
  vase.on = "table";
  vase.for_each = true;
  vase.asked = false;
  vase.spare = 1;
  const Plan plan = rooms::plan_of({table, vase, rooms::item("chair")}, rooms::room_with_door(6, 6));
  const auto designer = make_rule_designer();
  const auto library = create::make_created_library();
  const auto builder = RoomBuilder::begin(plan, *designer, *library, KindTable::built_in());
  REQUIRE(builder);
  std::map<std::string, int> on;
  for (const auto& item : builder->plan().items)
    if (item.category == "vase") on[item.on] += item.quantity;
  CHECK(on == std::map<std::string, int>{{"table-0", 2}, {"table-1", 2}});
  CHECK(builder->left()[2].id == "chair-0");
  std::map<std::string, int> lie;
  for (const auto& object : made(plan).scene.objects)
    if (object.category == "vase") ++lie[object.on];
  CHECK(lie == on);
}
