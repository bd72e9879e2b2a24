#include <nlohmann/json.hpp>

#include "arguments.h"
#include "plan_text.h"
#include "roomgen/base/file.h"
#include "tools.h"

namespace roomgen::mcp {

namespace {

Json item_json(const PlanItem& item) {
  Json json = {{"category", item.category}, {"quantity", item.quantity}};
  if (!item.description.empty()) json["description"] = item.description;
  if (item.asked) json["asked"] = true;
  for (const auto& relation : item.relations) json["relations"].push_back(to_text(relation));
  return json;
}

Json room_json(const Plan& plan) {
  const Vec2 box = bounds(plan.room.polygon).size();
  Json json = {{"type", plan.room.type},
               {"size", {rounded(box.x(), 2), rounded(box.y(), 2)}},
               {"area", rounded(area(plan.room.polygon), 2)},
               {"height", rounded(plan.room.height, 2)},
               {"openings", Json::array()},
               {"things", Json::array()}};
  if (!plan.room.id.empty()) json["id"] = plan.room.id;
  for (const auto& opening : plan.room.openings) json["openings"].push_back(opening.id);
  for (const auto& item : plan.items) json["things"].push_back(item_json(item));
  return json;
}

void add_ledger(const std::vector<Requirement>& requirements, const std::vector<Heard>& heard, Json& json) {
  for (const auto& requirement : requirements) json["requirements"].push_back(requirement.clause);
  for (const auto& words : heard)
    if (words.as == Heard::As::not_understood) json["not_understood"].push_back(words.text);
}

Json short_json(const cli::AnyPlan& plan) {
  Json json = {{"rooms", Json::array()},
               {"requirements", Json::array()},
               {"not_understood", Json::array()},
               {"notes", cli::notes_of(plan)}};
  if (const auto* single = std::get_if<Plan>(&plan)) {
    json["rooms"].push_back(room_json(*single));
    add_ledger(single->requirements, single->heard, json);
    return json;
  }
  const auto& dwelling = std::get<DwellingPlan>(plan);
  add_ledger(dwelling.requirements, dwelling.heard, json);
  for (const auto& room : dwelling.rooms) {
    json["rooms"].push_back(room_json(room));
    add_ledger(room.requirements, {}, json);
  }
  return json;
}

}  // namespace

Result<ToolAnswer> plan_room(Workplace& place, const ToolCall& call) {
  const auto wish = plan_wish(place, call.arguments);
  if (!wish) return wish.error();
  const auto designer = make_rule_designer();
  const auto made = cli::make_plan(*wish, *designer, call.cancel);
  if (!made) return made.error();
  auto lines = cli::plan_lines(*made);
  Json data = short_json(*made);
  for (const auto& words : data["not_understood"]) lines.push_back("not understood: " + words.get<std::string>());
  if (call.arguments.contains("save_to")) {
    const auto file = new_file(place, call.arguments["save_to"].get<std::string>(), ".json");
    if (!file) return file.error();
    if (auto status = write_file(*file, dump_json(cli::plan_json(*made))); !status) return status.error();
    data["file"] = place.root.name_of(*file);
    lines.push_back("written to " + place.root.name_of(*file));
  }
  return text_answer(text_of(lines), std::move(data));
}

}  // namespace roomgen::mcp
