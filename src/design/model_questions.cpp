#include "model_questions.h"

#include <algorithm>
#include <map>

#include "base/json_values.h"
#include "plan/claim.h"
#include "plan_form.h"
#include "together.h"
#include "roomgen/base/text.h"

namespace roomgen::design {

namespace {

constexpr std::size_t most_named_later = 60;  // of the plan's items
constexpr int tokens_for_other = 160;
constexpr std::size_t most_offered = 30;    // ids among which the model chooses the next

// The names of the prompts of a mode, without "-system" and "-user".
std::string_view place_prompt(const ModelDesignerOptions& options) {
  if (options.steps == ModelSteps::groups) return "place-groups";
  switch (options.mode) {
    case ModelMode::constraints:
      return "place-constraints";
    case ModelMode::image:
      return "place-image";
    case ModelMode::fused:
      break;
  }
  return "place";
}

Json place_schema(const ModelDesignerOptions& options) {
  Json schema = json_literal(R"({"type": "object", "additionalProperties": false,
    "properties": {"reasoning": {"type": "string"}, "constraints": {"type": "string"}},
    "required": ["reasoning", "constraints"]})");
  const auto require = [&](const char* key, const char* form) {
    schema["properties"][key] = json_literal(form);
    schema["required"].push_back(key);
  };
  if (options.mode == ModelMode::fused) {
    require("location", R"({"type": "array", "items": {"type": "number"}})");
    require("facing", R"({"anyOf": [{"type": "string"}, {"type": "number"}, {"type": "null"}]})");
  }
  if (options.chooses_order) require("next", R"({"type": "string"})");
  if (options.steps == ModelSteps::groups) {
    require("leave_out", R"({"anyOf": [{"type": "string"}, {"type": "null"}]})");
    require("bottom_m", R"({"anyOf": [{"type": "number"}, {"type": "null"}]})");
    require("size_cm", R"({"anyOf": [{"type": "array", "items": {"type": "number"}}, {"type": "null"}]})");
    require("move", R"({"type": "array", "items": {"type": "object", "additionalProperties": false,
      "properties": {"id": {"type": "string"}, "location": {"type": "array", "items": {"type": "number"}},
        "facing": {"anyOf": [{"type": "number"}, {"type": "null"}]}}, "required": ["id", "location", "facing"]}})");
  }
  return schema;
}

// For several things at once: a list of the same, each with its id.
void add_others(Json& schema) {
  Json one = schema;
  one["properties"].erase("next");
  one["properties"].erase("move");
  one["properties"]["id"] = {{"type", "string"}};
  one["required"] = Json::array();
  for (const auto& [key, value] : one["properties"].items()) one["required"].push_back(key);
  schema["properties"]["others"] = {{"type", "array"}, {"items", one}};
  schema["required"].push_back("others");
}

std::string together(const PlaceRequest& request, const std::vector<PlannedObject>& others) {
  if (others.empty()) return "";
  const bool on_thing = request.plan.items[request.planned.item].mount == Mount::surface;
  std::string text =
      "\nGive also \"others\", a list with the same members and \"id\" for each of these, " +
      std::string(on_thing ? "which stand on the same thing:"
                           : "so that all of them together make a good room. Constraints may name what is placed "
                             "and what stands before it in this list:");
  for (const auto& other : others) text += "\n" + line_of(request.plan, other);
  return text;
}

std::string where(const PlaceRequest& request) {
  const PlanItem& item = request.plan.items[request.planned.item];
  switch (item.mount) {
    case Mount::floor:
      return "on the floor";
    case Mount::wall:
      return "on a wall";
    case Mount::ceiling:
      return "under the ceiling";
    case Mount::surface:
      return item.on.empty() ? "on a table or cabinet" : "on " + item.on;
  }
  return "";
}

// Kinds with their numbers and sizes: enough to leave room for them.
std::string later(const PlaceRequest& request) {
  std::map<std::size_t, int> counts;  // by item
  for (const auto& planned : planned_objects(request.plan))
    if (std::find(request.later.begin(), request.later.end(), planned.id) != request.later.end())
      ++counts[planned.item];
  std::vector<std::string> names;
  std::size_t left = 0;
  for (const auto& [index, count] : counts) {
    const PlanItem& item = request.plan.items[index];
    if (names.size() >= most_named_later)
      left += static_cast<std::size_t>(count);
    else
      names.push_back((count > 1 ? std::to_string(count) + " " : "") + item.category + " (" +
                      size_text(item.size.value_or(KindTable::built_in().get(item.category).size)) +
                      ")");
  }
  if (left > 0) names.push_back("and " + std::to_string(left) + " more things");
  return names.empty() ? "nothing" : join(names, ", ");
}

std::string requirement_lines(const std::vector<Requirement>& requirements) {
  std::string lines;
  for (const auto& one : requirements) lines += one.id + ": " + told(one) + "\n";
  return lines.empty() ? "nothing in particular\n" : lines;
}

}  // namespace

Result<ChatRequest> ModelQuestions::make_question(std::string_view name, const Prompts::Slots& system,
                                  const Prompts::Slots& user) const {
  auto introduction = prompts_.render(std::string(name) + "-system", system);
  if (!introduction) return introduction.error();
  auto task = prompts_.render(std::string(name) + "-user", user);
  if (!task) return task.error();
  ChatRequest question;
  question.messages = {{ChatMessage::Role::system, *std::move(introduction), {}},
                       {ChatMessage::Role::user, *std::move(task), {}}};
  return question;
}

Result<ChatRequest> ModelQuestions::to_plan(const PlanRequest& request, const brief::Brief& brief) const {
  std::string room;
  if (request.room)
    room = "The room is given: " + SceneText(*request.room, false).room() + ".";
  else if (request.size)
    room = "The room is given: " + format_number(request.size->x(), 2) + " x " +
           format_number(request.size->y(), 2) + " m.";
  const bool whole = options_.steps == ModelSteps::groups;
  Prompts::Slots system, user = {{"prompt", request.prompt}, {"room", room}};
  if (whole) {
    system = {{"kinds", kind_names(KindTable::built_in())}};
    user["requirements"] = requirement_lines(plan::clauses_of(request, brief, KindTable::built_in()));
    user["compositions"] = composition_lines(request.room ? request.room->type : brief.type, brief,
                                             lower(request.prompt));
  }
  auto question = make_question(whole ? "design" : "plan", system, user);
  if (!question) return question;
  question->schema = plan_schema(whole);
  question->schema_name = "plan";
  question->max_tokens = options_.plan_tokens;
  question->cancel = request.cancel;
  if (request.pictures.empty()) return question;
  auto pictures = prompts_.render("design-pictures", {{"count", counted_pictures(request)}});
  if (!pictures) return pictures.error();
  question->messages.back().text += "\n" + *pictures;
  question->messages.back().images = request.pictures;
  return question;
}

std::string counted_pictures(const PlanRequest& request) {
  const std::size_t count = request.pictures.size();
  return count == 1 ? "a picture" : std::to_string(count) + " pictures";
}

Result<Prompts::Slots> ModelQuestions::system_slots(const SceneText& text) const {
  auto vocabulary = prompts_.render("place-words", {});
  if (!vocabulary) return vocabulary.error();
  return Prompts::Slots{{"frame", text.frame()}, {"words", *std::move(vocabulary)}};
}

Result<ChatRequest> ModelQuestions::to_place(const PlaceRequest& request, const Known& known) const {
  const SceneText text(request.scene.room, options_.paper_frame);
  const bool sees_places = options_.mode != ModelMode::constraints;
  const bool has_news = sees_places && !known.news.empty();
  const std::string news =
      has_news ? "Not all is as you said: " + join(known.news, "; ") + "\n" : std::string();
  const auto others = answered_together(request, options_.steps, known.answered);
  const auto system = system_slots(text);
  if (!system) return system.error();
  auto question = make_question(place_prompt(options_), *system,
                                {{"prompt", request.plan.prompt},
                                 {"concept", known.idea.empty() ? "" : "Your design: " + known.idea + "\n"},
                                 {"room", text.room()},
                                 {"parts", text.parts()},
                                 {"placed", text.placed(request.scene.objects, sees_places)},
                                 {"later", later(request)},
                                 {"id", request.object.id},
                                 {"description", request.object.description + group_text(request.plan, request.planned)},
                                 {"size", size_text(request.object.size)},
                                 {"mount", where(request)},
                                 {"refusals", news + refusals(request, text)},
                                 {"order", order(request) + together(request, others)}});
  if (!question) return question;
  question->schema = place_schema(options_);
  if (!others.empty()) add_others(question->schema);
  question->schema_name = "placement";
  question->max_tokens = options_.place_tokens + tokens_for_other * static_cast<int>(others.size());
  question->cancel = request.cancel;
  return question;
}

std::string ModelQuestions::refusals(const PlaceRequest& request, const SceneText& text) const {
  const bool sees_places = options_.mode != ModelMode::constraints;
  std::string lines;
  for (std::size_t i = 0; i < request.refusals.size(); ++i) {
    lines += "An earlier answer did not work";
    if (i < request.earlier.size()) lines += " (" + text.answer(request.earlier[i]) + ")";
    lines += ": " + request.refusals[i] + "\n";
  }
  if (!request.objections.empty() && !request.earlier.empty() && request.standing_at)
    lines += "Your last answer (" + text.answer(request.earlier.back()) + ") puts it at " +
             (sees_places ? text.point(*request.standing_at) : "a place of its own") +
             ". Not all is as you said: " +
             join(request.objections, "; ") +
             ". Answer once more: change what should change, or repeat the answer if that will do.\n";
  if (!request.refusals.empty() && sees_places)
    lines +=
        "Free floor (shaded green in the picture): " + text.free_floor(request.free_floor) + "\n";
  return lines;
}

std::string ModelQuestions::order(const PlaceRequest& request) const {
  if (!options_.chooses_order || request.later.empty()) return "";
  std::vector<std::string> ids = request.later;
  if (ids.size() > most_offered) ids.resize(most_offered);
  return "Give also \"next\": which one shall be placed after this. Large things and those that "
         "others refer to come first. Of: " +
         join(ids, ", ") + ".";
}

}  // namespace roomgen::design
