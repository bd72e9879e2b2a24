#include <nlohmann/json.hpp>

#include "base/random.h"
#include "catch.h"
#include "roomgen/base/json.h"
#include "roomgen/scene/plan.h"
#include "scene/finish.h"
#include "scene/lights.h"
#include "scene/wall_sides.h"
#include "support/contains.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

const std::vector<std::string> looks_of_parts = {"sage walls", "oak panelling", "#8a9a5b", "white tiles",
                                           "navy striped wallpaper", "lightsteelblue walls", ""};
const std::vector<std::string> names_of_walls = {"wall-0", "wall-2", "north", "east", "south", "west", "accent"};

template <typename T>
std::optional<T> perhaps(Random& random, const T& value) {
  return random.chance(0.5) ? std::optional(value) : std::nullopt;
}

Lighting random_light(Random& random) {
  Lighting light;
  light.hour = perhaps(random, 0.25 * random.integer(0, 96));
  light.sky = perhaps(random, random.pick(std::vector{Sky::clear, Sky::cloudy, Sky::overcast, Sky::night}));
  light.lux = perhaps(random, 1.0 * random.integer(0, 1000));
  light.kelvin = perhaps(random, 100.0 * random.integer(15, 65));
  if (random.chance(0.5)) light.lamps.emplace();
  for (int n = random.integer(0, 2); light.lamps && n > 0; --n) light.lamps->push_back("lamp-" + std::to_string(n));
  return light;
}

Plan random_plan(std::uint64_t seed) {
  Random random(seed);
  Plan plan;
  plan.room = rooms::box(4, 3);
  RoomMaterials& materials = plan.room.materials;
  materials.floor = random.pick(looks_of_parts);
  materials.walls = random.pick(looks_of_parts);
  if (random.chance(0.3)) materials.covers.push_back({"", "", WallBand{random.pick(looks_of_parts), 1.2}});
  for (const auto& name : names_of_walls)
    if (random.chance(0.4))
      materials.covers.push_back({name, random.pick(looks_of_parts), perhaps(random, WallBand{random.pick(looks_of_parts), 0.25 * random.integer(0, 10)})});
  plan.room.light = random_light(random);
  if (random.chance(0.5)) plan.room.style = {"mid-century", "cosy"};
  for (const auto& role : palette_roles)
    if (random.chance(0.4)) plan.room.palette.emplace(role, random.pick(std::vector<std::string>{"sage", "#102030", "oak"}));
  for (int n = random.integer(0, 3); n > 0; --n) {
    WantedOpening wanted;
    wanted.kind = random.pick(std::vector<std::string>{"door", "french door", "round window"});
    if (random.chance(0.7)) wanted.wall = names_of_walls[static_cast<std::size_t>(random.integer(0, 5))];
    if (!wanted.wall.empty() && random.chance(0.5)) wanted.at = 0.125 * random.integer(0, 8);
    else if (!wanted.wall.empty()) wanted.offset = perhaps(random, 0.25 * random.integer(-4, 4));
    wanted.width = perhaps(random, 1.25);
    wanted.sill = perhaps(random, 0.5);
    wanted.head = perhaps(random, 2.25);
    wanted.purpose = random.pick(std::vector<std::string>{"", "to the garden"});
    plan.openings.push_back(wanted);
  }
  return plan;
}

Json some_plan() { return to_json(random_plan(1)); }

Plan plan_of(const Json& json) {
  auto plan = plan_from_json(json, "p.json");
  if (!plan) FAIL(plan.error().message);
  return *std::move(plan);
}

}  // namespace

TEST_CASE("how a room looks and which openings it wants is read back as it was written") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Plan plan = random_plan(seed);
    const Plan again = plan_of(to_json(plan));
    INFO(dump_json(to_json(plan)));
    CHECK(again.notes.empty());
    CHECK(again.room.materials.floor == plan.room.materials.floor);
    CHECK(again.room.materials.walls == plan.room.materials.walls);
    CHECK(again.room.materials.covers == plan.room.materials.covers);
    CHECK(again.room.light == plan.room.light);
    CHECK(again.room.style == plan.room.style);
    CHECK(again.room.palette == plan.room.palette);
    CHECK(again.openings == plan.openings);
  }
}

TEST_CASE("what cannot be so is told with its place, and the rest of the plan is made") {
  using Change = void (*)(Json&);
  const std::vector<std::pair<Change, const char*>> cases = {
      {[](Json& j) { j["room"]["light"] = {{"hour", 31}, {"level", "dim"}}; }, "/room/light/hour: 31 "},
      {[](Json& j) { j["room"]["light"] = {{"sky", "plaid"}}; }, "/room/light/sky: \"plaid\""},
      {[](Json& j) { j["room"]["light"] = {{"warmth", -3}}; }, "/room/light/warmth: -3 "},
      {[](Json& j) { j["room"]["light"] = {{"level", "blinding-ish"}}; }, "/room/light/level: "},
      {[](Json& j) { j["room"]["palette"] = {{"main", "flurb"}}; }, "/room/palette/main: \"flurb\""},
      {[](Json& j) { j["room"]["palette"] = {{"main", "#12345"}}; }, "/room/palette/main: \"#12345\""},
      {[](Json& j) { j["room"]["palette"] = {{"third", "red"}}; }, "/room/palette/third: "},
      {[](Json& j) { j["room"]["materials"] = {{"floor", "#zzzzzz"}}; }, "/room/materials/floor: "},
      {[](Json& j) { j["room"]["materials"] = {{"walls", {{{"wall", 9}, {"finish", "red"}}}}}; }, "/room/materials/walls: \"wall-9\""},
      {[](Json& j) { j["room"]["materials"] = {{"walls", {{{"wall", "up"}, {"finish", "red"}}}}}; }, "/room/materials/walls/0/wall: \"up\""},
      {[](Json& j) { j["openings"] = {{{"kind", "dor"}}}; }, "/openings/0/kind: \"dor\" is no kind of opening that is known; did you mean \"door\"?"},
      {[](Json& j) { j["openings"] = {{{"kind", "door"}, {"wall", "wall-4"}}}; }, "/openings/0/wall: \"wall-4\""},
      {[](Json& j) { j["openings"] = {{{"kind", "door"}, {"wall", 1}, {"at", 1.5}}}; }, "/openings/0/at: 1.5 "},
  };
  for (const auto& [change, expected] : cases) {
    Json json = to_json(random_plan(3));
    change(json);
    const Plan plan = plan_of(json);
    INFO(expected);
    REQUIRE(plan.notes.size() == 1);
    CHECK(contains_text(plan.notes[0], expected));
    CHECK(plan_of(to_json(plan)).notes == plan.notes);  // told once
  }
  Json json = some_plan();
  json["room"]["light"] = {{"hour", 31}, {"level", "dim"}};
  CHECK_FALSE(plan_of(json).room.light.hour);
  CHECK(plan_of(json).room.light.lux == 50.0);
  for (const auto& [key, value] : {std::pair<const char*, Json>{"light", "noon"}, {"light", {{"hour", "noon"}}}, {"palette", {"red"}}}) {
    Json broken = some_plan();
    broken["room"][key] = value;
    const auto plan = plan_from_json(broken, "p.json");
    REQUIRE_FALSE(plan);
    CHECK(contains_text(plan.error().message, std::string("/room/") + key));
  }
}

TEST_CASE("walls of a file that counts its corners clockwise are those that it means") {
  Json json = to_json(random_plan(1));
  json["room"]["polygon"] = {{0, 0}, {0, 3}, {4, 3}, {4, 0}};  // wall 0 is in the west, wall 1 in the north
  json["room"]["materials"] = {{"walls", {{{"wall", 1}, {"finish", "red"}}}}};
  json["openings"] = {{{"kind", "door"}, {"wall", 0}, {"at", 0.25}}, {{"kind", "door"}, {"wall", "north"}, {"at", 0.25}}};
  const Plan plan = plan_of(json);
  const auto at_wall = [&](std::string_view name) {
    return plan.room.polygon.edge(walls_named(plan.room, name).front()).middle();
  };
  REQUIRE(plan.room.materials.covers.size() == 1);
  CHECK(at_wall(plan.room.materials.covers[0].wall) == Vec2(2, 3));
  // Three quarters of a metre from its first corner (0, 0), on a wall that runs from (0, 3) here.
  CHECK(at_wall(plan.openings[0].wall) == Vec2(0, 1.5));
  CHECK(plan.openings[0].offset == Approx(0.75));
  CHECK(plan.openings[1].at == Approx(0.75));
}

TEST_CASE("each wall wears what is said of it, else what is said of the others") {
  Room room = rooms::box(4, 3);
  room.materials.walls = "white walls";
  room.materials.covers = {{"", "", WallBand{"oak panelling", 1.1}},
                           {"north", "navy walls", {}},
                           {"wall-1", "", WallBand{"", 0.0}},
                           {"wall-2", "red walls", {}}};  // the north wall, which has its words already
  CHECK(cover_of(room, 0) == WallCover{"wall-0", "white walls", WallBand{"oak panelling", 1.1}});
  CHECK(cover_of(room, 1) == WallCover{"wall-1", "white walls", {}});
  CHECK(cover_of(room, 2) == WallCover{"wall-2", "navy walls", WallBand{"oak panelling", 1.1}});
  room.materials = {"", "white walls", ""};
  cover_named(room.materials, accent_name).finish = "brick wall";
  CHECK(cover_of(room, accent_wall(room)).finish == "brick wall");
}

TEST_CASE("colours by code and by the names of CSS") {
  const auto color = [](const char* text) { return make_finish(text, RoomPart::walls, "").material.base_color; };
  CHECK(color("#ff0000 walls") == material_color({255, 0, 0}));
  CHECK(color("lightsteelblue") == material_color({176, 196, 222}));
  CHECK(color("#ff00001") == color("walls"));
  CHECK(says_finish("#a0b0c0"));
  CHECK(says_finish("brass"));
  CHECK_FALSE(says_finish("#a0b0c"));
  CHECK_FALSE(says_finish("the flurb"));
}

TEST_CASE("the room's light says which lamps burn and whether there is a sun") {
  Scene scene = rooms::scene(rooms::box(4, 3), {rooms::thing("floor lamp-0", "floor lamp", {0.4, 0.4, 1.6}, {1, 1}),
                                                rooms::thing("table lamp-0", "table lamp", {0.3, 0.3, 0.5}, {2, 1})});
  scene.room.openings = {rooms::window("window-0", 0, 1, 3)};
  Lighting& light = scene.room.light;
  CHECK(lamp_lights(scene).size() == 2);
  CHECK(sunlight(scene.room));
  light.lamps = {"table lamp"};
  REQUIRE(lamp_lights(scene).size() == 1);
  CHECK(lamp_lights(scene)[0].object == "table lamp-0");
  light.kelvin = 2000;
  const auto warm = lamp_lights(scene)[0].color;
  light.kelvin = 6500;
  const auto cool = lamp_lights(scene)[0].color;
  CHECK(warm[2] < 0.5f * cool[2]);
  CHECK(warm[0] > cool[0]);
  light.lamps = std::vector<std::string>();
  CHECK(lamp_lights(scene).empty());
  light.hour = 23;
  CHECK_FALSE(sunlight(scene.room));
  light.sky = Sky::clear;
  CHECK(sunlight(scene.room));
  light.sky = Sky::overcast;
  CHECK_FALSE(sunlight(scene.room));
  CHECK(is_day(light));
}
