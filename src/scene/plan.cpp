#include "roomgen/scene/plan.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "document_parts.h"
#include "file_limits.h"
#include "file_walls.h"
#include "room_look_json.h"
#include "wanted_opening_json.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"
#include "roomgen/scene/plan.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

namespace {

constexpr std::size_t max_items = 5000, max_requirements = 5000, max_groups = 500;
constexpr long long max_quantity = 200;
constexpr std::size_t longest_key = 200'000;  // of what is made from a program

template <typename Placed>
void put_suggestion(const Placed& placed, Json& json) {
  if (!placed.relations.empty()) json["constraints"] = to_text(placed.relations);
  if (placed.location)
    json["location"] = {rounded(placed.location->x()), rounded(placed.location->y())};
  if (placed.facing) json["facing"] = rounded(degrees(*placed.facing));
}

Json item_json(const PlanItem& item) {
  Json json;
  json["category"] = item.category;
  json["description"] = item.description;
  if (item.size)
    json["size"] = {rounded(item.size->x()), rounded(item.size->y()), rounded(item.size->z())};
  if (!item.asset.empty()) json["asset"] = item.asset;
  if (!item.left_out.empty()) json["left_out"] = item.left_out;
  json["quantity"] = item.quantity;
  if (item.for_each) json["per"] = "each";
  json["variance"] = item.varied ? "varied" : "same";
  json["mount"] = name(item.mount);
  if (!item.on.empty()) json["on"] = item.on;
  json["asked"] = item.asked;
  put_suggestion(item, json);
  if (item.height) json["height"] = rounded(*item.height);
  if (!item.tilt.isZero()) json["tilt"] = tilt_json(item.tilt);
  if (item.bottom) json["bottom"] = rounded(*item.bottom);
  if (!item.group.empty()) json["group"] = item.group, json["part"] = item.part;
  if (!item.serves.empty()) json["serves"] = item.serves;
  if (item.spare > 0) json["spare"] = item.spare;
  return json;
}

// Of an item or a group.
template <typename Placed>
void read_suggestion(const JsonReader& json, Placed& placed) {
  SaidPlace said = read_said_place(json);
  placed.relations = std::move(said.relations);
  placed.location = said.location;
  placed.facing = said.facing;
}

// Of two words the second one; the first unless something is said.
bool read_choice(const JsonReader& json, const std::string& first, const std::string& second) {
  const std::string said = json.text_or(first);
  if (said != first && said != second)
    json.report("must be \"" + first + "\" or \"" + second + "\"");
  return said == second;
}

// How high it hangs, if it does.
std::optional<double> read_height(const JsonReader& json, const PlanItem& item, const Room& room) {
  if (!json.exists()) return std::nullopt;
  const double height = json.number(0.0, 50.0);
  const bool hangs = item.mount == Mount::wall || item.mount == Mount::ceiling || !item.group.empty();
  if (!hangs) json.remark("only what hangs on a wall or from the ceiling has a height; left open");
  else if (height > room.height)
    json.remark(format_number(height, 2) + " m is above the ceiling, which is " +
                format_number(room.height, 2) + " m high; it hangs as high as it can");
  return hangs ? std::optional(height) : std::nullopt;
}

// What leans at a wall stands with its back to it, tilted backwards.
void read_lean(const JsonReader& json, PlanItem& item) {
  if (!json.exists()) return;
  if (item.mount == Mount::wall || item.mount == Mount::ceiling)
    json.report("what leans stands: its mount is floor or surface");
  item.tilt = {-radians(json.number(0.0, 60.0)), 0.0};
  const Relation at_wall{RelationKind::edge, ""};
  if (std::find(item.relations.begin(), item.relations.end(), at_wall) == item.relations.end())
    item.relations.push_back(at_wall);
}

PlanItem read_item(const JsonReader& json, const Room& room, int usual_spare = 0) {
  json.allow_only({"category", "description", "size",  "quantity",    "per",      "variance",
                   "mount",    "on",          "asked", "constraints", "location", "facing",
                   "height",   "bottom",      "tilt",  "lean",        "group",    "part",
                   "serves",   "spare",       "asset", "left_out"});
  PlanItem item;
  item.category = lower(json["category"].text(200));
  item.description = json["description"].text_or("");
  if (const auto size = json["size"]; size.exists()) {
    const auto v = size.numbers(3, 0.001, 50.0);
    item.size = Vec3(v[0], v[1], v[2]);
  }
  item.asset = json["asset"].text_or("", longest_key);
  item.left_out = json["left_out"].text_or("");
  item.group = json["group"].text_or("", 200);
  item.part = json["part"].text_or("", 200);
  if (item.group.empty() != item.part.empty()) json.report("\"group\" and \"part\" belong together");
  const int all_of_part = item.group.empty() ? 1 : 0;
  item.quantity = static_cast<int>(json["quantity"].integer_or(all_of_part, all_of_part, max_quantity));
  item.serves = json["serves"].text_or("", 200);
  item.spare = static_cast<int>(json["spare"].integer_or(usual_spare, 0, 1000));
  item.for_each = read_choice(json["per"], "all", "each");
  item.varied = read_choice(json["variance"], "same", "varied");
  const std::string mount = json["mount"].text_or("floor");
  if (auto parsed = parse_mount(mount)) item.mount = *parsed;
  else json["mount"].report("\"" + mount + "\" is none of floor, wall, ceiling, surface");
  item.on = lower(json["on"].text_or("", 200));
  if (item.for_each && (item.on.empty() || !item.group.empty()))
    json["per"].report("\"each\" needs \"on\", which says of what; in a group its composition counts");
  item.asked = json["asked"].boolean_or(item.spare == 0);
  if (item.asked && item.spare > 0) {
    json["asked"].remark("what is spare only dresses the room; taken as not asked for");
    item.asked = false;
  }
  read_suggestion(json, item);
  item.tilt = read_tilt(json["tilt"]);
  read_lean(json["lean"], item);
  item.height = read_height(json["height"], item, room);
  item.bottom = read_height(json["bottom"], item, room);
  if (item.height && item.bottom)
    json["bottom"].report("say either \"height\", of its middle, or \"bottom\", of its lower edge");
  return item;
}

Json group_json(const PlanGroup& group) {
  Json json;
  json["id"] = group.id;
  if (!group.composition.empty()) json["composition"] = group.composition;
  for (const auto& [name, value] : group.parameters) {
    if (const double* number = std::get_if<double>(&value)) json["with"][name] = rounded(*number);
    else json["with"][name] = std::get<std::string>(value);
  }
  if (!group.fixed.empty()) json["fixed"] = group.fixed;
  if (!group.without.empty()) json["without"] = group.without;
  if (const auto definition = parse_json(group.definition.empty() ? "{}" : group.definition, group.id))
    for (const auto& [key, value] : definition->items()) json[key] = value;
  put_suggestion(group, json);
  json["asked"] = group.asked;
  return json;
}

PlanGroup read_group(const JsonReader& json) {
  json.allow_only({"id", "composition", "with", "fixed", "without", "parameters", "parts", "mirrors",
                   "constraints", "location", "facing", "asked"});
  PlanGroup group;
  group.id = json["id"].text(200);
  group.composition = json["composition"].text_or("", 200);
  Json definition;
  for (const auto* key : {"parameters", "parts", "mirrors"})
    if (const auto value = json[key]; value.exists()) definition[key] = *value.raw();
  if (!definition.is_null()) group.definition = json_line(definition);
  if (group.composition.empty() && group.definition.empty())
    json.report("a group names a \"composition\" or has \"parts\" of its own");
  if (const auto with = json["with"]; with.exists())
    for (const auto& [name, value] : with.members()) {
      if (value.is_string()) group.parameters[name] = value.text(100);
      else group.parameters[name] = value.number(-1000, 1000);
    }
  for (const auto& name : json["fixed"].elements_or_none(100)) group.fixed.insert(name.text(100));
  for (const auto& name : json["without"].elements_or_none(100)) group.without.insert(name.text(200));
  read_suggestion(json, group);
  group.asked = json["asked"].boolean_or(true);
  return group;
}

std::vector<PlanGroup> read_groups(const JsonReader& json) {
  std::vector<PlanGroup> groups;
  std::set<std::string> ids;
  for (const auto& element : json.elements_or_none(max_groups)) {
    groups.push_back(read_group(element));
    if (!ids.insert(groups.back().id).second)
      element["id"].report("another group is called \"" + groups.back().id + "\"");
  }
  return groups;
}

// What the file says and cannot be is told once, also where the plan is written and read again.
void add_remarks(const JsonReader::Problems& problems, Plan& plan) {
  for (const auto& remark : problems.remarks())
    if (std::find(plan.notes.begin(), plan.notes.end(), remark) == plan.notes.end())
      plan.notes.push_back(remark);
}

}  // namespace

SaidPlace read_said_place(const JsonReader& json) {
  SaidPlace said;
  auto relations = parse_relations(json["constraints"].text_or(""));
  if (relations) said.relations = *std::move(relations);
  else json["constraints"].report(relations.error().message);
  if (const auto location = json["location"]; location.exists()) {
    const auto point = location.numbers(2, -max_coordinate, max_coordinate);
    said.location = Vec2(point[0], point[1]);
  }
  if (const auto facing = json["facing"]; facing.exists())
    said.facing = radians(facing.number(-36000, 36000));
  return said;
}

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
  if (!plan.openings.empty()) json["openings"] = to_json(plan.openings);
  json["objects"] = Json::array();
  for (const auto& item : plan.items) json["objects"].push_back(item_json(item));
  for (const auto& group : plan.groups) json["groups"].push_back(group_json(group));
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
  root.allow_only({"format", "version", "prompt", "seed", "room", "openings", "objects", "groups", "dressing", "excluded",
                   "notes", "requirements", "heard"});
  if (root["version"].integer_or(1, 1, 1000) != 1)
    root["version"].report("this version of roomgen reads version 1 only");
  Plan plan;
  plan.prompt = root["prompt"].text_or("", 100000);
  plan.seed = static_cast<std::uint64_t>(root["seed"].integer_or(0, 0, max_seed));
  plan.room = read_room(root["room"]);
  plan.groups = read_groups(root["groups"]);
  for (const auto& element : plan.groups.empty() ? root["objects"].elements(max_items)
                                                 : root["objects"].elements_or_none(max_items))
    plan.items.push_back(read_item(element, plan.room));
  for (const auto& element : root["dressing"].elements_or_none(max_items))
    plan.items.push_back(read_item(element, plan.room, 1));
  for (const auto& element : root["excluded"].elements_or_none(max_items))
    plan.excluded.push_back(element.text());
  for (const auto& element : root["notes"].elements_or_none(max_items))
    plan.notes.push_back(element.text());
  for (const auto& element : root["requirements"].elements_or_none(max_requirements))
    plan.requirements.push_back(read_requirement(element));
  plan.heard = read_heard(root["heard"]);
  if (problems.first()) return *problems.first();
  const auto corners = read_corners(root["room"]["polygon"]);
  plan.openings = read_wanted_openings(root["openings"], corners, plan.room);
  remark_on_finishes(root["room"]["materials"]);
  if (problems.first()) return *problems.first();
  add_remarks(problems, plan);
  const FileWalls walls(corners, plan.room.polygon);
  for (auto& item : plan.items) walls.rename(item.relations);
  for (auto& group : plan.groups) walls.rename(group.relations);
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
