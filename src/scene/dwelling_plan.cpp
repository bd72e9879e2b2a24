#include "roomgen/scene/plan.h"

#include <map>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "dwelling.h"
#include "file_limits.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

namespace {

constexpr std::size_t max_notes = 500;

using Renaming = std::map<std::string, std::string, std::less<>>;

void rename(std::string& id, const Renaming& names) {
  if (const auto found = names.find(id); found != names.end()) id = found->second;
}

void rename(Plan& plan, const Renaming& names) {
  for (auto& item : plan.items) {
    rename(item.on, names);
    for (auto& relation : item.relations) rename(relation.target, names);
  }
  for (auto& requirement : plan.requirements) {
    for (auto& id : requirement.subjects) rename(id, names);
    for (auto& id : requirement.targets) rename(id, names);
  }
}

// Every room counts on from those before it.
void set_first_numbers(DwellingPlan& plan) {
  std::map<std::string, int, std::less<>> counts;
  for (auto& room : plan.rooms) {
    room.first_numbers = counts;
    for (const auto& item : room.items) counts[lower(item.category)] += item.quantity;
  }
}

}  // namespace

void number_through(DwellingPlan& plan) {
  std::vector<std::vector<PlannedObject>> before;
  for (const auto& room : plan.rooms) before.push_back(planned_objects(room));
  set_first_numbers(plan);
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    const auto after = planned_objects(plan.rooms[i]);
    Renaming names;
    for (std::size_t n = 0; n < after.size(); ++n) names[before[i][n].id] = after[n].id;
    rename(plan.rooms[i], names);
  }
}

bool is_dwelling_plan(const Json& json) {
  return json.is_object() && json.contains("rooms");
}

Json to_json(const DwellingPlan& plan) {
  Json json;
  json["format"] = "roomgen-plan";
  json["version"] = 1;
  json["prompt"] = plan.prompt;
  json["seed"] = plan.seed;
  json["rooms"] = Json::array();
  for (const auto& room : plan.rooms) json["rooms"].push_back(to_json(room));
  json["notes"] = plan.notes;
  for (const auto& requirement : plan.requirements)
    json["requirements"].push_back(to_json(requirement));
  if (!plan.heard.empty()) json["heard"] = to_json(plan.heard);
  return json;
}

Result<DwellingPlan> dwelling_plan_from_json(const Json& json, const std::string& source) {
  JsonReader::Problems problems(source);
  const JsonReader root(json, problems);
  if (root["format"].text_or("") != "roomgen-plan")
    root.report("not a plan: \"format\" must be \"roomgen-plan\"");
  if (root["version"].integer_or(1, 1, 1000) != 1)
    root["version"].report("this version of roomgen reads version 1 only");
  root.allow_only({"format", "version", "prompt", "seed", "rooms", "notes", "requirements", "heard"});
  DwellingPlan plan;
  plan.prompt = root["prompt"].text_or("", 100000);
  plan.seed = static_cast<std::uint64_t>(root["seed"].integer_or(0, 0, max_seed));
  for (const auto& element : root["notes"].elements_or_none(max_notes))
    plan.notes.push_back(element.text());
  for (const auto& element : root["requirements"].elements_or_none(max_notes))
    plan.requirements.push_back(read_requirement(element));
  plan.heard = read_heard(root["heard"]);
  const auto rooms = root["rooms"].elements(max_rooms);
  if (problems.first()) return *problems.first();
  std::vector<Room> shells;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    auto room = plan_from_json(*rooms[i].raw(), source + ": /rooms/" + std::to_string(i));
    if (!room) return room.error();
    shells.push_back(room->room);
    plan.rooms.push_back(*std::move(room));
  }
  if (shells.empty())
    return Error{Error::Kind::invalid_input, source + ": the dwelling has no rooms"};
  if (auto status = check_dwelling(shells); !status) return with_context(status.error(), source);
  set_first_numbers(plan);
  return plan;
}

}  // namespace roomgen
