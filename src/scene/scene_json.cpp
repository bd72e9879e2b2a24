#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "document_parts.h"
#include "file_limits.h"
#include "file_walls.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

namespace {

constexpr std::size_t max_objects = 5000;

Vec3 vec3(const std::vector<double>& v) {
  return {v[0], v[1], v[2]};
}

Json numbers(const Vec3& v) {
  return {rounded(v.x()), rounded(v.y()), rounded(v.z())};
}

Json object_json(const Object& object) {
  Json json;
  json["id"] = object.id;
  json["category"] = object.category;
  json["description"] = object.description;
  json["asset"] = to_json(object.asset);
  json["traits"] = Json::array();
  if (object.traits.front) json["traits"].push_back("front");
  if (object.traits.flat) json["traits"].push_back("flat");
  if (object.traits.round) json["traits"].push_back("round");
  json["size"] = numbers(object.size);
  json["position"] = numbers(object.position);
  json["yaw_deg"] = rounded(degrees(wrap_angle(object.yaw)), 3);
  json["mount"] = name(object.mount);
  json["on"] = object.on.empty() ? Json() : Json(object.on);
  json["relations"] = Json::array();
  for (const auto& relation : object.relations) json["relations"].push_back(to_text(relation));
  json["locked"] = object.locked;
  if (object.stand_in) json["stand_in"] = true;
  if (!object.room.empty()) json["room"] = object.room;
  if (!object.group.empty()) json["group"] = object.group;
  return json;
}

Traits read_traits(const JsonReader& json) {
  Traits traits{false, false, false};
  for (const auto& element : json.elements_or_none(10)) {
    const std::string trait = element.text();
    if (trait == "front") traits.front = true;
    else if (trait == "flat") traits.flat = true;
    else if (trait == "round") traits.round = true;
    else element.report("\"" + trait + "\" is none of front, flat, round");
  }
  return traits;
}

Object read_object(const JsonReader& json) {
  json.allow_only({"id", "category", "description", "asset", "traits", "size", "position", "yaw_deg",
                   "mount", "on", "relations", "locked", "stand_in", "room", "group"});
  Object object;
  object.id = json["id"].text(200);
  object.category = json["category"].text_or("", 200);
  object.description = json["description"].text_or("");
  object.asset = read_asset(json["asset"]);
  object.traits = read_traits(json["traits"]);
  object.size = vec3(json["size"].numbers(3, 1e-4, max_coordinate));
  object.position = vec3(json["position"].numbers(3, -max_coordinate, max_coordinate));
  object.yaw = radians(json["yaw_deg"].number_or(0, -36000, 36000));
  const std::string mount = json["mount"].text_or("floor");
  if (auto parsed = parse_mount(mount)) object.mount = *parsed;
  else json["mount"].report("\"" + mount + "\" is none of floor, wall, ceiling, surface");
  object.on = json["on"].text_or("", 200);
  for (const auto& element : json["relations"].elements_or_none(100)) {
    auto relation = parse_relation(element.text(500));
    if (relation) object.relations.push_back(*relation);
    else element.report(relation.error().message);
  }
  object.locked = json["locked"].boolean_or(false);
  object.stand_in = json["stand_in"].boolean_or(false);
  object.room = json["room"].text_or("", 200);
  object.group = json["group"].text_or("", 200);
  return object;
}

// Relations count walls as the file does, each in its object's room.
void rename_walls(Scene& scene, const JsonReader& root) {
  const auto rooms = rooms_of(scene);
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    const JsonReader json = scene.rooms.empty() ? root["room"] : root["rooms"].elements(max_rooms)[i];
    const FileWalls walls(read_corners(json["polygon"]), rooms[i].polygon);
    for (auto& object : scene.objects)
      if (scene.rooms.empty() || object.room == rooms[i].id) walls.rename(object.relations);
  }
}

}  // namespace

Json to_json(const Scene& scene) {
  Json json;
  json["format"] = "roomgen-scene";
  json["version"] = 1;
  json["units"] = "m";
  json["up"] = "+z";
  json["front"] = "-y";
  json["prompt"] = scene.prompt;
  json["seed"] = scene.seed;
  if (scene.incomplete) json["incomplete"] = true;
  if (scene.rooms.empty()) json["room"] = to_json(scene.room);
  for (const auto& room : scene.rooms) json["rooms"].push_back(to_json(room));
  json["objects"] = Json::array();
  for (const auto& object : scene.objects) json["objects"].push_back(object_json(object));
  json["unplaced"] = Json::array();
  for (const auto& missing : scene.unplaced)
    json["unplaced"].push_back(
        {{"id", missing.id}, {"category", missing.category}, {"reason", missing.reason}});
  for (const auto& verdict : scene.requirements) json["requirements"].push_back(to_json(verdict));
  if (!scene.heard.empty()) json["heard"] = to_json(scene.heard);
  for (const auto& verdict : scene.program)
    json["program"].push_back({{"name", verdict.name}, {"held", verdict.held}, {"amount", rounded(verdict.amount)}});
  return json;
}

Result<Scene> scene_from_json(const Json& json, const std::string& source) {
  JsonReader::Problems problems(source);
  const JsonReader root(json, problems);
  if (root["format"].text_or("") != "roomgen-scene")
    root.report("not a scene: \"format\" must be \"roomgen-scene\"");
  if (root["version"].integer_or(1, 1, 1000) != 1)
    root["version"].report("this version of roomgen reads version 1 only");
  root.allow_only({"format", "version", "units", "up", "front", "prompt", "seed", "incomplete",
                   "room", "rooms", "objects", "unplaced", "requirements", "heard", "program"});
  Scene scene;
  scene.prompt = root["prompt"].text_or("", 100000);
  scene.seed = static_cast<std::uint64_t>(root["seed"].integer_or(0, 0, max_seed));
  scene.incomplete = root["incomplete"].boolean_or(false);
  if (root["rooms"].exists() && root["room"].exists())
    root.report("has both \"room\" and \"rooms\"; a dwelling has \"rooms\" only");
  if (root["rooms"].exists())
    for (const auto& element : root["rooms"].elements(max_rooms))
      scene.rooms.push_back(read_room(element));
  else
    scene.room = read_room(root["room"]);
  for (const auto& element : root["objects"].elements(max_objects))
    scene.objects.push_back(read_object(element));
  for (const auto& element : root["unplaced"].elements_or_none(max_objects))
    scene.unplaced.push_back({element["id"].text(), element["category"].text_or(""),
                              element["reason"].text_or("")});
  for (const auto& element : root["requirements"].elements_or_none(max_objects))
    scene.requirements.push_back(read_verdict(element));
  scene.heard = read_heard(root["heard"]);
  for (const auto& element : root["program"].elements_or_none(max_objects))
    scene.program.push_back({element["name"].text(200), element["held"].boolean_or(false),
                             element["amount"].number_or(0.0, 0.0, 1e12)});
  if (auto status = problems.all(); !status) return status.error();
  rename_walls(scene, root);
  if (auto status = check(scene); !status) return with_context(status.error(), source);
  return scene;
}

Result<Scene> read_scene(const std::filesystem::path& path) {
  auto text = read_file(path);
  if (!text) return text.error();
  auto json = parse_json(*text, path.string());
  if (!json) return json.error();
  return scene_from_json(*json, path.string());
}

}  // namespace roomgen
