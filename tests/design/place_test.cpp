#include <nlohmann/json.hpp>
#include <set>

#include "catch.h"
#include "plans.h"
#include "roomgen/base/json.h"
#include "roomgen/scene/scene.h"
#include "solve/place.h"
#include "solve/support.h"

using namespace roomgen;
using roomgen::test::plan_of;

namespace {

Object object_of(const Plan& plan, const PlannedObject& planned) {
  const PlanItem& item = plan.items[planned.item];
  const Kind& category = KindTable::built_in().get(item.category);
  Object object;
  object.id = planned.id;
  object.category = item.category;
  object.traits = category.traits;
  object.size = item.size.value_or(category.size);
  object.mount = item.mount;
  return object;
}

PlaceAdvice advice_for(const Plan& plan, const Scene& scene, const PlannedObject& planned,
                       const Object& object) {
  const PlaceRequest request{plan, scene, planned, object};
  return *make_rule_designer()->place(request);
}

// Places everything as boxes, with what the rules answer.
struct Furnished {
  Scene scene;
  int missed = 0;
};

Furnished furnish(const Plan& plan) {
  Furnished result;
  const ModelTable boxes;
  Layout layout(plan.room, KindTable::built_in(), boxes, &*built_in_arrangements());
  Random random(1);
  result.scene.room = plan.room;
  for (const auto& planned : planned_objects(plan)) {
    const PlanItem& item = plan.items[planned.item];
    PlacementTask task;
    task.object = object_of(plan, planned);
    task.object.position.z() =
        mounting_height(item.mount, task.object.size.z(), 1.2, plan.room);
    const auto advice = advice_for(plan, result.scene, planned, task.object);
    task.object.relations = advice.relations;
    task.usual = advice.usual;
    task.of_its_kind = quantity_of(plan, item.category);
    if (item.mount == Mount::surface) choose_support(layout, item.on, 0, task);
    auto placed = place(layout, task, {}, {}, random);
    if (!placed) {
      ++result.missed;
      continue;
    }
    result.scene.objects.push_back(placed->object);
    layout.add(std::move(placed->object));
  }
  return result;
}

bool overlaps_something(const Scene& scene, std::size_t i) {
  const Object& a = scene.objects[i];
  if (a.mount != Mount::floor || a.traits.flat) return false;
  for (std::size_t j = 0; j < i; ++j) {
    const Object& b = scene.objects[j];
    if (b.mount == Mount::floor && !b.traits.flat && overlaps(footprint(a), footprint(b), 0.01))
      return true;
  }
  return false;
}

const Object* first_of(const Scene& scene, const std::string& category) {
  for (const auto& object : scene.objects)
    if (KindTable::built_in().is_a(object.category, category)) return &object;
  return nullptr;
}

}  // namespace

TEST_CASE("what goes where its kind usually does is inside, free of overlap and names only what is placed") {
  for (const char* type : test::room_types)
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      INFO(type << ", seed " << seed);
      const Plan plan = plan_of(type, seed);
      const Furnished room = furnish(plan);
      CHECK(room.missed <= 1);  // boxes are larger than what they hold
      std::set<std::string> known{"corner"};
      for (const auto& opening : plan.room.openings) known.insert(opening.id);
      for (std::size_t k = 0; k < plan.room.polygon.size(); ++k)
        known.insert("wall-" + std::to_string(k));
      for (std::size_t i = 0; i < room.scene.objects.size(); ++i) {
        const Object& object = room.scene.objects[i];
        INFO(object.id << ": " << to_text(object.relations));
        CHECK(contains(plan.room.polygon, footprint(object), 0.005));
        CHECK_FALSE(overlaps_something(room.scene, i));
        for (const auto& relation : object.relations)
          CHECK((relation.target.empty() || known.count(relation.target)));
        known.insert(object.id);
      }
    }
}

TEST_CASE("beds stand with the head at a wall, between their nightstands") {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    INFO("seed " << seed);
    const Scene scene =
        furnish(plan_of("a bedroom with a double bed and two nightstands", seed)).scene;
    const Object* bed = first_of(scene, "bed");
    REQUIRE(bed);
    const Footprint fp = footprint(*bed);
    CHECK(distance_to_boundary(scene.room.polygon, Vec2(fp.to_world({0, fp.half().y()}))) < 0.05);
    double sides = 0.0;
    for (const auto& object : scene.objects)
      if (object.category == "nightstand") {
        const double side = fp.to_local(object.position.head<2>()).x();
        CHECK(std::abs(side) > fp.half().x());
        sides += side > 0 ? 1 : -1;
      }
    CHECK(sides == 0.0);
  }
}

TEST_CASE("televisions face sofas and chairs their tables") {
  int facing = 0, televisions = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Scene scene = furnish(plan_of("a living room with a sofa and a tv stand", seed)).scene;
    const Object* sofa = first_of(scene, "sofa");
    const Object* stand = first_of(scene, "tv stand");
    REQUIRE(sofa);
    REQUIRE(stand);
    ++televisions;
    facing +=
        ray_hit(footprint(*sofa), stand->position.head<2>(), front_direction(stand->yaw)) >= 0;
  }
  CHECK(facing == televisions);
  const Scene dining = furnish(plan_of("dining room", 1)).scene;
  const Object* table = first_of(dining, "dining table");
  REQUIRE(table);
  for (const auto& object : dining.objects)
    if (object.category == "dining chair")
      CHECK(ray_hit(footprint(*table), object.position.head<2>(), front_direction(object.yaw)) >=
            0);
}

TEST_CASE("what the prompt says of places comes first among the relations") {
  const Plan plan = plan_of("a bedroom with a bed and a desk to the left of the bed", 2);
  const Scene scene = furnish(plan).scene;
  const Object* desk = first_of(scene, "desk");
  REQUIRE(desk);
  REQUIRE_FALSE(desk->relations.empty());
  CHECK(to_text(desk->relations.front()) == "right of, bed-0");
}

TEST_CASE("rules say what is asked and leave the place to the solver") {
  const Plan plan = plan_of("a bedroom with a bed and a desk to the left of the bed", 2);
  Scene scene;
  scene.room = plan.room;
  for (const auto& planned : planned_objects(plan)) {
    const auto advice = advice_for(plan, scene, planned, object_of(plan, planned));
    CHECK(advice.usual);
    CHECK_FALSE(advice.location);
    CHECK_FALSE(advice.yaw);
    CHECK(advice.relations.size() <= plan.items[planned.item].relations.size());
  }
}

TEST_CASE("equal plans are placed alike") {
  const Plan plan = plan_of("kitchen", 5);
  const Scene a = furnish(plan).scene, b = furnish(plan).scene;
  CHECK(dump_json(to_json(a)) == dump_json(to_json(b)));
}
