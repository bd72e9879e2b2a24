#include "asset_making.h"

#include <algorithm>

#include "asset_text.h"
#include "base/json_values.h"
#include "chat/loose_json.h"
#include "roomgen/base/text.h"

namespace roomgen::design {

namespace {

using Programs = std::map<std::size_t, std::string>;

constexpr std::size_t most_unusable = 20, most_notes = 8, longest_note = 300;

// Into the programs; else what is wrong with it. `item`: where the list is an object, its key.
std::string read_one(const Json& given, std::string item, const MakingRequest& request,
                     Programs& programs) {
  if (!given.is_object()) return ": is no object with \"item\" and \"program\"";
  if (const Json* said = member(given, {"item", "id", "number"}))
    item = said->is_number_integer() ? std::to_string(said->get<long long>()) : text_in(said);
  const Json* program = member(given, {"program", "shape"});
  if (!program && member(given, {"components"})) program = &given;
  std::size_t i = 0;
  while (i < request.things.size() && request.things[i].offer.id != item) ++i;
  if (i == request.things.size())
    return "/item: \"" + shortened(item, 40) + "\" was not to be made";
  if (!program || !program->is_object()) return "/program: is no program";
  if (programs.emplace(i, json_line(*program)).second) return "";
  return ": item " + item + " was written before; the first counts";
}

// The list, with what solids and parts look like at the place where references look for it.
Json answer_schema(Json program) {
  Json schema = json_literal(R"({"type": "object", "additionalProperties": false,
    "properties": {"things": {"type": "array", "items": {"type": "object",
      "additionalProperties": false, "required": ["item", "program"],
      "properties": {"item": {"type": "string"}}}}}, "required": ["things"]})");
  schema["$defs"] = std::move(program["$defs"]);
  program.erase("$defs");
  schema["properties"]["things"]["items"]["properties"]["program"] = std::move(program);
  return schema;
}

// What else of the plan belongs to it.
std::string company(const Plan& plan, const PlanItem& item) {
  std::string others;
  for (const auto& other : plan.items) {
    const bool is_near =
        other.on == item.category || (!item.group.empty() && other.group == item.group);
    if (&other == &item || !is_near || !other.left_out.empty()) continue;
    others += (others.empty() ? "; goes with: " : ", ") + other.category;
    if (other.size) others += " (" + size_text(*other.size) + " m)";
  }
  return others;
}

std::string thing_text(const Plan& plan, const ThingToMake& thing) {
  std::string text = offer_head(plan, thing.offer) + company(plan, plan.items[thing.offer.items.front()]);
  if (!thing.program.empty()) text += "\n   Written: " + thing.program;
  for (std::size_t i = 0; i < std::min(thing.notes.size(), most_notes); ++i)
    text += "\n   - " + shortened(thing.notes[i], longest_note);
  return text;
}

Question question_of(const MakingRequest& request, const std::string& shapes, bool sees) {
  Question question;
  question.system = "make-system";
  question.user = request.again ? "make-again-user" : "make-user";
  std::vector<std::string> things;
  for (const auto& thing : request.things) things.push_back(thing_text(request.plan, thing));
  question.system_slots = {{"shapes", shapes}};
  question.user_slots = {{"prompt", request.plan.prompt},
                         {"room", room_line(request.plan.room)},
                         {"things", join(things, "\n")}};
  if (request.again)
    question.user_slots["pictures"] =
        sees ? "The pictures show what came of it, each thing from the front quarter and from "
               "behind, at one scale."
             : "";
  question.schema = answer_schema(request.form);
  question.schema_name = "things";
  question.cancel = request.cancel;
  return question;
}

}  // namespace

Result<Reading<Programs>> read_programs(std::string_view text, const MakingRequest& request) {
  auto found = find_json(text, {{"things"}, {"objects", "items", "programs"}});
  if (!found) return found.error();
  Reading<Programs> result{{}, std::move(found->repairs)};
  const Json* list = member(found->json, {"things", "objects", "items", "programs"});
  const bool is_list = list && list->is_structured();
  static const Json nothing = Json::object();
  for (const auto& [key, value] : (is_list ? *list : nothing).items()) {
    const std::string problem =
        read_one(value, list->is_object() ? key : "", request, result.value);
    if (!problem.empty() && result.repairs.size() < most_unusable)
      result.repairs.push_back("/things/" + key + problem);
  }
  if (result.value.empty() && !(request.again && is_list))
    return Error{Error::Kind::invalid_input,
                 "the answer makes nothing; give \"things\": [{\"item\": \"1\", \"program\": {…}}, "
                 "…]; " +
                     join(result.repairs, "; ")};
  return result;
}

Result<Programs> ask_for_programs(const MakingRequest& request, const Call& call,
                                  std::vector<std::string>& notes) {
  const auto shapes = call.prompts.render("create-generate-system", {});
  if (!shapes) return shapes.error();
  return call.ask(
      question_of(request, *shapes, !call.images.empty()),
      [&](const std::string& text) { return read_programs(text, request); }, notes);
}

}  // namespace roomgen::design
