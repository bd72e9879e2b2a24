#include <set>

#include "catch.h"
#include "plans.h"
#include "roomgen/base/json.h"
#include "roomgen/scene/scene.h"

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

PlaceAdvice place(const Plan& plan, const Scene& scene, const PlannedObject& planned,
                  const Object& object, std::vector<std::string> refusals = {}) {
  const PlaceRequest request{plan, scene, planned, object, std::move(refusals)};
  return *make_rule_designer()->place(request);
}

// Puts everything where it is advised to go.
struct Furnished {
  Scene scene;
  int missed = 0;
};

Furnished furnish(const Plan& plan) {
  Furnished result;
  result.scene.room = plan.room;
  for (const auto& planned : planned_objects(plan)) {
    Object object = object_of(plan, planned);
    const auto advice = place(plan, result.scene, planned, object);
    if (!advice.location || !advice.yaw) {
      ++result.missed;
      continue;
    }
    object.position.head<2>() = *advice.location;
    object.yaw = *advice.yaw;
    object.relations = advice.relations;
    for (const auto& relation : advice.relations)
      if (relation.kind == RelationKind::on) object.on = relation.target;
    result.scene.objects.push_back(std::move(object));
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

TEST_CASE("advice is inside the room, free of overlap and names only what is placed") {
  for (const char* type : test::room_types)
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      INFO(type << ", seed " << seed);
      const Plan plan = plan_of(type, seed);
      const Furnished room = furnish(plan);
      CHECK(room.missed == 0);
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

TEST_CASE("what the prompt says of places comes first in the advice") {
  const Plan plan = plan_of("a bedroom with a bed and a desk to the left of the bed", 2);
  const Scene scene = furnish(plan).scene;
  const Object* desk = first_of(scene, "desk");
  REQUIRE(desk);
  REQUIRE_FALSE(desk->relations.empty());
  CHECK(to_text(desk->relations.front()) == "right of, bed-0");
}

TEST_CASE("a refusal leads to another place and to fewer wishes") {
  const Plan plan = plan_of("living room", 4);
  Scene scene;
  scene.room = plan.room;
  const auto planned = planned_objects(plan).front();
  const Object object = object_of(plan, planned);
  const auto first = place(plan, scene, planned, object);
  const auto second = place(plan, scene, planned, object, {"it blocks the door"});
  REQUIRE(first.location);
  REQUIRE(second.location);
  CHECK((*first.location - *second.location).norm() > 0.3);
  const auto many = place(plan, scene, planned, object, std::vector<std::string>(9, "no"));
  CHECK(many.relations.size() <= first.relations.size());
}

TEST_CASE("equal requests get equal advice") {
  const Plan plan = plan_of("kitchen", 5);
  const Scene a = furnish(plan).scene, b = furnish(plan).scene;
  CHECK(dump_json(to_json(a)) == dump_json(to_json(b)));
}
