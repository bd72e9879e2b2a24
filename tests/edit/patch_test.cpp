#include "scene_patch.h"

#include <nlohmann/json.hpp>

#include "catch.h"
#include "small_scenes.h"

using namespace roomgen;

TEST_CASE("A patch leads from either of two scenes to the other") {
  Random random(11);
  Scene scene = row_of_boxes(6);
  for (int step = 0; step < 2000; ++step) {
    Scene next = scene;
    for (int changes = random.integer(0, 4); changes > 0; --changes) next = changed_by_chance(next, random);
    if (random.chance(0.1)) random.shuffle(next.objects);
    const Json before = to_json(scene), after = to_json(next);
    const Json patch = scene_patch(before, after);
    CHECK(patch.empty() == (before == after));
    const auto forth = apply_patch(before, patch);
    REQUIRE(forth);
    CHECK(dump_json(*forth) == dump_json(after));
    const auto back = apply_patch(after, inverse_patch(patch));
    REQUIRE(back);
    CHECK(dump_json(*back) == dump_json(before));
    scene = std::move(next);
  }
}

TEST_CASE("A patch says no more than what changed") {
  const Scene scene = row_of_boxes(40);
  Scene next = scene;
  next.objects[20].position.x() += 0.5;
  const std::string patch = scene_patch(to_json(scene), to_json(next)).dump();
  CHECK(patch == R"({"lists":{"objects":[{"id":"box-20","before":{"position":[20.5,2.0,0.0]},)"
                 R"("after":{"position":[21.0,2.0,0.0]}}]}})");
}

TEST_CASE("A patch of another scene is refused, whatever it says") {
  Random random(5);
  for (int round = 0; round < 500; ++round) {
    const Scene scene = row_of_boxes(4);
    const Scene other = changed_by_chance(changed_by_chance(row_of_boxes(5), random), random);
    const Json patch = scene_patch(to_json(other), to_json(changed_by_chance(other, random)));
    const auto result = apply_patch(to_json(scene), patch);
    if (result) CHECK(scene_patch(to_json(scene), *result) == patch);
  }
  const Json document = to_json(row_of_boxes(2));
  for (const char* text : {R"({"lists":{"objects":3}})", R"({"lists":{"objects":[{"at":9,"after":{"id":"a"}}]}})",
                           R"({"lists":{"objects":[{"at":0,"before":{"id":"z"}}]}})", R"({"lists":{"format":[]}})",
                           R"({"lists":{"objects":[7,{}]}})", R"({"members":{"seed":{"before":5,"after":6}}})",
                           R"({"lists":{"objects":[{"id":"box-0","before":4,"after":[]}]}})"})
    CHECK(!apply_patch(document, Json::parse(text)));
}

TEST_CASE("A patch that would swell a scene is refused") {
  Json many = Json::array(), keys = Json::object();
  for (int i = 0; i < 30'000; ++i) many.push_back({{"at", 0}, {"after", {{"id", std::to_string(i)}}}});
  for (int i = 0; i < 100; ++i) keys["m" + std::to_string(i)] = {{"before", nullptr}, {"after", i}};
  const Json document = to_json(row_of_boxes(2));
  CHECK(!apply_patch(document, {{"lists", {{"objects", many}}}}));
  CHECK(!apply_patch(document, {{"members", keys}}));
}
