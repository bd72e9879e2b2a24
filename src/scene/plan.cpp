#include "roomgen/scene/plan.h"

#include <map>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "document_parts.h"
#include "file_limits.h"
#include "file_walls.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/scene/plan.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

namespace {

constexpr std::size_t max_items = 5000, max_requirements = 5000;
constexpr long long max_quantity = 200;

Json item_json(const PlanItem& item) {
  Json json;
  json["category"] = item.category;
  json["description"] = item.description;
  if (item.size)
    json["size"] = {rounded(item.size->x()), rounded(item.size->y()), rounded(item.size->z())};
  json["quantity"] = item.quantity;
  json["variance"] = item.varied ? "varied" : "same";
  json["mount"] = name(item.mount);
  if (!item.on.empty()) json["on"] = item.on;
  json["asked"] = item.asked;
  if (!item.relations.empty()) json["constraints"] = to_text(item.relations);
  if (item.location) json["location"] = {rounded(item.location->x()), rounded(item.location->y())};
  if (item.facing) json["facing"] = rounded(degrees(*item.facing));
  if (item.height) json["height"] = rounded(*item.height);
  return json;
}

PlanItem read_item(const JsonReader& json) {
  json.allow_only({"category", "description", "size", "quantity", "variance", "mount", "on", "asked",
                   "constraints", "location", "facing", "height"});
  PlanItem item;
  item.category = lower(json["category"].text(200));
  item.description = json["description"].text_or("");
  if (const auto size = json["size"]; size.exists()) {
    const auto v = size.numbers(3, 0.001, 50.0);
    item.size = Vec3(v[0], v[1], v[2]);
  }
  item.quantity = static_cast<int>(json["quantity"].integer_or(1, 1, max_quantity));
  const std::string variance = json["variance"].text_or("same");
  if (variance != "same" && variance != "varied")
    json["variance"].report("must be \"same\" or \"varied\"");
  item.varied = variance == "varied";
  const std::string mount = json["mount"].text_or("floor");
  if (auto parsed = parse_mount(mount)) item.mount = *parsed;
  else json["mount"].report("\"" + mount + "\" is none of floor, wall, ceiling, surface");
  item.on = lower(json["on"].text_or("", 200));
  item.asked = json["asked"].boolean_or(true);
  auto relations = parse_relations(json["constraints"].text_or(""));
  if (relations) item.relations = *std::move(relations);
  else json["constraints"].report(relations.error().message);
  if (const auto location = json["location"]; location.exists()) {
    const auto v = location.numbers(2, -max_coordinate, max_coordinate);
    item.location = Vec2(v[0], v[1]);
  }
  if (const auto facing = json["facing"]; facing.exists()) item.facing = radians(facing.number(-36000, 36000));
  if (const auto height = json["height"]; height.exists()) item.height = height.number(0.0, 50.0);
  return item;
}

}  // namespace

int quantity_of(const Plan& plan, std::string_view category) {
  int count = 0;
  for (const auto& item : plan.items)
    if (item.category == category) count += item.quantity;
  return count;
}

std::vector<PlannedObject> planned_objects(const Plan& plan) {
  std::vector<PlannedObject> objects;
  auto next_number = plan.first_numbers;
  for (std::size_t i = 0; i < plan.items.size(); ++i)
    for (int n = 0; n < plan.items[i].quantity; ++n) {
      const std::string category = lower(plan.items[i].category);
      objects.push_back({category + "-" + std::to_string(next_number[category]++), i, n});
    }
  return objects;
}

Json to_json(const Plan& plan) {
  Json json;
  json["format"] = "roomgen-plan";
  json["version"] = 1;
  json["prompt"] = plan.prompt;
  json["seed"] = plan.seed;
  json["room"] = to_json(plan.room);
  json["objects"] = Json::array();
  for (const auto& item : plan.items) json["objects"].push_back(item_json(item));
  json["excluded"] = plan.excluded;
  json["notes"] = plan.notes;
  json["requirements"] = Json::array();
  for (const auto& requirement : plan.requirements)
    json["requirements"].push_back(to_json(requirement));
  if (!plan.heard.empty()) json["heard"] = to_json(plan.heard);
  return json;
}

Result<Plan> plan_from_json(const Json& json, const std::string& source) {
  if (is_dwelling_plan(json))
    return Error{Error::Kind::invalid_input, source + ": is the plan of a dwelling, not of one room"};
  JsonReader::Problems problems(source);
  const JsonReader root(json, problems);
  if (root["format"].text_or("") != "roomgen-plan")
    root.report("not a plan: \"format\" must be \"roomgen-plan\"");
  root.allow_only({"format", "version", "prompt", "seed", "room", "objects", "excluded", "notes",
                   "requirements", "heard"});
  if (root["version"].integer_or(1, 1, 1000) != 1)
    root["version"].report("this version of roomgen reads version 1 only");
  Plan plan;
  plan.prompt = root["prompt"].text_or("", 100000);
  plan.seed = static_cast<std::uint64_t>(root["seed"].integer_or(0, 0, max_seed));
  plan.room = read_room(root["room"]);
  for (const auto& element : root["objects"].elements(max_items))
    plan.items.push_back(read_item(element));
  for (const auto& element : root["excluded"].elements_or_none(max_items))
    plan.excluded.push_back(element.text());
  for (const auto& element : root["notes"].elements_or_none(max_items))
    plan.notes.push_back(element.text());
  for (const auto& element : root["requirements"].elements_or_none(max_requirements))
    plan.requirements.push_back(read_requirement(element));
  plan.heard = read_heard(root["heard"]);
  if (problems.first()) return *problems.first();
  const FileWalls walls(read_corners(root["room"]["polygon"]), plan.room.polygon);
  for (auto& item : plan.items) walls.rename(item.relations);
  return plan;
}

Result<Plan> read_plan(const std::filesystem::path& path) {
  auto text = read_file(path);
  if (!text) return text.error();
  auto json = parse_json(*text, path.string());
  if (!json) return json.error();
  return plan_from_json(*json, path.string());
}

}  // namespace roomgen
