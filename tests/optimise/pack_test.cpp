// Packing: nothing invalid, nothing worse than before, nothing moved that may not move.

#include "optimise/pack.h"

#include <algorithm>

#include "base/random.h"
#include "catch.h"
#include "roomgen/evaluate/report.h"
#include "roomgen/scene/scene.h"

using namespace roomgen;

namespace {

Room room_of_size(double width, double depth) {
  Room room;
  room.type = "living room";
  room.polygon = *make_polygon({{0, 0}, {width, 0}, {width, depth}, {0, depth}});
  Opening door;
  door.id = "door-0";
  door.from = 0.2, door.to = 1.1;
  room.openings = {door};
  return room;
}

PackThing thing(const std::string& category, int number, bool edge) {
  PackThing result;
  result.object.category = category;
  result.object.id = category + "-" + std::to_string(number);
  result.object.size = KindTable::built_in().get(category).size;
  result.object.traits = KindTable::built_in().get(category).traits;
  if (edge) result.object.relations = {{RelationKind::edge, ""}};
  result.asked = true;
  return result;
}

std::vector<PackThing> crowd(Random& random) {
  std::vector<PackThing> things;
  const std::vector<std::string> names{"wardrobe", "sofa", "desk", "bookshelf", "armchair", "dresser"};
  for (int i = 0; i < 9; ++i) things.push_back(thing(random.pick(names), i, random.chance(0.7)));
  return things;
}

Scene scene_of(const Room& room, const std::vector<Object>& objects) {
  Scene scene;
  scene.room = room;
  scene.objects = objects;
  return scene;
}

}  // namespace

TEST_CASE("Packed rooms are valid and hold what they hold exactly once") {
  Random random(4);
  for (int round = 0; round < 12; ++round) {
    const double width = random.uniform(3.0, 5.0), depth = random.uniform(3.0, 4.5);
    const Room room = room_of_size(width, depth);
    const auto things = crowd(random);
    PackOptions options;
    options.seed = static_cast<std::uint64_t>(round);
    options.steps = 4000;
    const Packing packing = pack(room, things, {}, KindTable::built_in(), options);
    CHECK(packing.is_better);
    CHECK_FALSE(packing.objects.empty());
    const auto report = examine(scene_of(room, packing.objects), {}, KindTable::built_in());
    for (const auto& violation : report.violations)
      UNSCOPED_INFO(name(violation.fault) << " " << violation.object << " " << violation.other);
    CHECK(report.violations.empty());
    std::vector<std::string> ids;
    for (const auto& object : packing.objects) ids.push_back(object.id);
    std::ranges::sort(ids);
    CHECK(std::ranges::adjacent_find(ids) == ids.end());
  }
}

TEST_CASE("What may not move stays to the bit, and what stood is not lost for nothing") {
  Random random(8);
  for (int round = 0; round < 8; ++round) {
    const Room room = room_of_size(4.2, 3.8);
    auto things = crowd(random);
    PackOptions options;
    options.steps = 3000;
    const Packing first = pack(room, things, {}, KindTable::built_in(), options);
    for (auto& each : things)
      for (const auto& object : first.objects)
        if (object.id == each.object.id) each.object = object, each.stands = true, each.movable = random.chance(0.5);
    const Packing second = pack(room, things, {}, KindTable::built_in(), options);
    CHECK((!second.is_better || second.objects.size() >= first.objects.size()));
    for (const auto& each : things) {
      if (!each.stands || each.movable) continue;
      const auto found = std::ranges::find_if(second.objects, [&](const Object& o) { return o.id == each.object.id; });
      REQUIRE(found != second.objects.end());
      CHECK(found->position == each.object.position);
      CHECK(found->yaw == each.object.yaw);
    }
    CHECK(examine(scene_of(room, second.objects), {}, KindTable::built_in()).violations.empty());
  }
}
