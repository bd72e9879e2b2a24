#include <nlohmann/json.hpp>

#include "catch.h"
#include "roomgen/base/json.h"
#include "roomgen/scene/scene.h"
#include "support/contains.h"

using namespace roomgen;

namespace {

// A sound scene with one thing changed by `change` on its JSON.
template <typename Change>
std::string complaint(Change change) {
  auto json = *parse_json(R"({"format": "roomgen-scene", "version": 1,
    "room": {"type": "x", "polygon": [[0,0],[4,0],[4,4],[0,4]], "openings":
      [{"id": "door-0", "type": "door", "wall": 0, "from": 0.5, "to": 1.4}]},
    "objects": [{"id": "bed-0", "size": [1,2,1], "position": [2,2,0], "yaw_deg": 90,
                 "relations": ["edge"]}]})", "s");
  change(json);
  const auto scene = scene_from_json(json, "s.json");
  if (scene) return "";
  CHECK(is_one_line(scene.error().message));
  CHECK(scene.error().message.rfind("s.json: ", 0) == 0);
  return scene.error().message;
}

}  // namespace

TEST_CASE("The scene that the following cases spoil is sound") {
  CHECK(complaint([](Json&) {}).empty());
}

TEST_CASE("Nothing stands on itself, nor is near itself") {
  const auto with = [](const char* first, const char* second) {
    return complaint([&](Json& j) {
      Json lamp = j["objects"][0], box = lamp;
      lamp["id"] = "lamp-0", box["id"] = "box-0";
      lamp["mount"] = box["mount"] = "surface";
      lamp["on"] = first, box["on"] = second;
      j["objects"].push_back(lamp);
      j["objects"].push_back(box);
    });
  };
  CHECK(with("bed-0", "lamp-0").empty());
  CHECK(contains_text(with("lamp-0", "bed-0"), "\"lamp-0\": stands on itself"));
  CHECK(contains_text(with("box-0", "lamp-0"), "stands on itself, or on what stands on it"));
  CHECK(contains_text(with("box-0", "nobody"), "stands on \"nobody\", which is not in the scene"));
  CHECK(contains_text(complaint([](Json& j) { j["objects"][0]["relations"] = {"near, bed-0"}; }), "cannot be \"near, bed-0\""));
}

TEST_CASE("Each mistake in a scene gives one located line") {
  using Change = void (*)(Json&);
  const std::vector<std::pair<Change, const char*>> cases = {
      {[](Json& j) { j["format"] = "other"; }, "\"format\" must be"},
      {[](Json& j) { j.erase("format"); }, "\"format\" must be"},
      {[](Json& j) { j["version"] = 2; }, "/version"},
      {[](Json& j) { j["objets"] = 1; }, "did you mean \"objects\"?"},
      {[](Json& j) { j.erase("objects"); }, "/objects: missing"},
      {[](Json& j) { j["objects"] = 3; }, "/objects: expected an array"},
      {[](Json& j) { j["seed"] = -1; }, "/seed"},
      {[](Json& j) { j["seed"] = 1.5; }, "/seed: expected a whole number"},
      {[](Json& j) { j["objects"][0].erase("id"); }, "/objects/0/id"},
      {[](Json& j) { j["objects"][0]["id"] = ""; }, "has no id"},
      {[](Json& j) { j["objects"][0]["id"] = 7; }, "/objects/0/id: expected a text"},
      {[](Json& j) { j["objects"][0]["size"] = {1, 2}; }, "/objects/0/size"},
      {[](Json& j) { j["objects"][0]["size"] = {1, 2, 0}; }, "/objects/0/size/2"},
      {[](Json& j) { j["objects"][0]["size"] = {1, 2, -1}; }, "/objects/0/size/2"},
      {[](Json& j) { j["objects"][0]["position"] = {1, 2, 1e9}; }, "/objects/0/position/2"},
      {[](Json& j) { j["objects"][0]["yaw_deg"] = "east"; }, "/objects/0/yaw_deg"},
      {[](Json& j) { j["objects"][0]["mount"] = "roof"; }, "/objects/0/mount"},
      {[](Json& j) { j["objects"][0]["traits"] = {"square"}; }, "/objects/0/traits/0"},
      {[](Json& j) { j["objects"][0]["relations"] = {"neer, x"}; }, "/objects/0/relations/0"},
      {[](Json& j) { j["objects"][0]["locked"] = "yes"; }, "/objects/0/locked"},
      {[](Json& j) { j["objects"][0]["colour"] = "red"; }, "/objects/0: unknown key"},
      {[](Json& j) { j["objects"].push_back(j["objects"][0]); }, "two of this id"},
      {[](Json& j) { j["objects"][0]["mount"] = "surface"; }, "not in the scene"},
      {[](Json& j) { j["objects"][0]["mount"] = "surface", j["objects"][0]["on"] = "sky-0"; }, "sky-0"},
      {[](Json& j) { j["objects"][0]["asset"] = {{"idd", "x"}}; }, "/objects/0/asset"},
      {[](Json& j) { j["unplaced"] = {{{"category", "x"}}}; }, "/unplaced/0/id"},
      {[](Json& j) { j.erase("room"); }, "/room"},
      {[](Json& j) { j = Json::array(); }, "expected an object"},
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    INFO("case " << i << ", expecting " << cases[i].second);
    const auto found = complaint(cases[i].first);
    INFO(found);
    CHECK(contains_text(found, cases[i].second));
  }
}
