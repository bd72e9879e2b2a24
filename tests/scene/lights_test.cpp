#include "scene/lights.h"

#include "catch.h"
#include "support/furnished_room.h"

using namespace roomgen;

namespace {

// All kinds that shine, somewhere in a room.
Scene lit_scene(std::uint64_t seed) {
  Random random(seed);
  Scene scene = test::random_scene(seed);
  int number = 0;
  for (const auto& [name, category] : KindTable::built_in().all()) {
    if (!category.lamp) continue;
    Object lamp = test::box("x-" + std::to_string(number++), category.size, Vec3::Zero());
    lamp.category = name;
    lamp.mount = category.mount;
    const Vec2 far = bounds(scene.room.polygon).high;
    lamp.position = {random.uniform(0.1, far.x() - 0.1), random.uniform(0.1, far.y() - 0.1), 0.0};
    if (lamp.mount == Mount::ceiling) lamp.position.z() = scene.room.height - lamp.size.z();
    if (lamp.mount == Mount::surface) lamp.position.z() = random.uniform(0.3, 1.0);
    if (lamp.mount == Mount::wall) lamp.position.z() = category.elevation;
    scene.objects.push_back(lamp);
  }
  return scene;
}

}  // namespace

TEST_CASE("lamps shine inside the room, at their things") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Scene scene = lit_scene(seed);
    const auto lights = lamp_lights(scene);
    CHECK(lights.size() > 10);
    for (const auto& light : lights) {
      const Object* object = find_object(scene, light.object);
      REQUIRE(object);
      INFO(object->category);
      CHECK(contains(scene.room.polygon, Vec2(light.position.head<2>())));
      CHECK(light.position.z() > 0.0);
      CHECK(light.position.z() < scene.room.height);
      CHECK((light.position - object->position).head<2>().norm() < 0.1);
      CHECK(light.position.z() > bottom(*object) - 0.05);
      CHECK(light.position.z() <= std::max(top(*object), 0.05));
      if (object->mount != Mount::ceiling)
        CHECK(light.position.z() >= bottom(*object) + 0.45 * object->size.z());
      CHECK(light.candela > 0.0);
    }
  }
}

TEST_CASE("what is no lamp does not shine") {
  Scene scene = test::furnished_room();
  const auto lights = lamp_lights(scene);
  REQUIRE(lights.size() == 1);
  CHECK(lights[0].object == "lamp-0");
}

TEST_CASE("kinds of lamps are lamps as well") {
  const auto& table = KindTable::built_in();
  for (const auto* kind : {"floor lamp", "desk lamp", "bedside lamp", "chandelier", "sconce", "pendant"}) {
    INFO(kind);
    CHECK(table.get(kind).lamp);
  }
  CHECK_FALSE(table.get("light switch").lamp);
  CHECK_FALSE(table.get("wardrobe").lamp);
}

TEST_CASE("a lamp that hangs into a wall shines before it") {
  Scene scene;
  scene.room = test::plain_room();
  Object lamp = test::box("sconce-0", {0.2, 0.2, 0.3}, {4.0, 1.5, 1.6});
  lamp.category = "wall lamp";
  scene.objects = {lamp};
  CHECK(contains(scene.room.polygon, Vec2(lamp_lights(scene).at(0).position.head<2>())));
}

TEST_CASE("the sun shines down into the widest window") {
  Room room = test::l_shaped_room();
  room.openings.push_back(test::opening("window-2", 4, 3.2, 3.6));
  const auto sun = sunlight(room);
  REQUIRE(sun);
  CHECK(sun->to_sun.norm() == Approx(1.0));
  CHECK(sun->to_sun.z() > 0.3);
  CHECK(sun->lux > 0.0);
  // Outside of wall 4, to the north.
  CHECK(sun->to_sun.head<2>().dot(inward(room, room.openings[1])) < -0.5);
  room.openings = {test::opening("door-0", 0, 4.6, 5.5)};
  CHECK_FALSE(sunlight(room));
}
