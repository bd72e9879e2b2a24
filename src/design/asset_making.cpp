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
const std::vector<std::string> thing_list_keys = {"things", "objects", "items", "programs"};

/// Reads the programs of one answer.
class ProgramsReader {
 public:
  ProgramsReader(const MakingRequest& request, Reading<Programs>& read)
      : request_(request), read_(read) {}

  // A list whose members say what they are of, or an object by items.
  void read(const Json& list) {
    for (const auto& [key, value] : list.items())
      read_one(value, list.is_object() ? key : "", "/things/" + key);
  }

 private:
  void problem(const std::string& place, const std::string& what) {
    if (read_.repairs.size() < most_unusable) read_.repairs.push_back(place + ": " + what);
  }

  void read_one(const Json& given, std::string item, const std::string& place) {
    if (!given.is_object()) return problem(place, "is no object with \"item\" and \"program\"");
    if (const Json* said = member(given, {"item", "id", "number"}); said && item.empty())
      item = said->is_number_integer() ? std::to_string(said->get<long long>()) : text_in(said);
    const auto& things = request_.things;
    const auto thing = std::find_if(things.begin(), things.end(),
                                    [&](const auto& one) { return one.offer.id == item; });
    if (thing == things.end())
      return problem(place + "/item", "\"" + shortened(item, 40) + "\" was not to be made");
    const Json* program = member(given, {"program", "shape"});
    if (!program && member(given, {"components"})) program = &given;
    if (!program || !program->is_object()) return problem(place + "/program", "is no program");
    if (!read_.value.emplace(static_cast<std::size_t>(thing - things.begin()), json_line(*program))
             .second)
      problem(place, "item " + item + " was written before; the first counts");
  }

  const MakingRequest& request_;
  Reading<Programs>& read_;
};

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
std::string company(const Plan& plan, const AssetOffer& offer) {
  const PlanItem& item = plan.items[offer.items.front()];
  std::vector<std::string> others;
  for (const auto& other : plan.items) {
    if (&other == &item || !other.left_out.empty()) continue;
    const bool is_near = std::any_of(
        other.relations.begin(), other.relations.end(),
        [&](const Relation& relation) { return relation.target.starts_with(item.category); });
    if (other.on == item.category || is_near || (!item.group.empty() && other.group == item.group))
      others.push_back(
          other.category +
          (other.size ? " (" + size_text(*other.size) + " m)" : std::string()));
  }
  return others.empty() ? "" : "; goes with: " + join(others, ", ");
}

std::string thing_text(const Plan& plan, const ThingToMake& thing) {
  std::string text = offer_head(plan, thing.offer) + company(plan, thing.offer);
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
  auto found = find_json(text, {{"things"}, thing_list_keys});
  if (!found) return found.error();
  Reading<Programs> result{{}, std::move(found->repairs)};
  const Json* list = member(found->json, thing_list_keys);
  if (list && list->is_structured()) ProgramsReader(request, result).read(*list);
  const bool is_content = request.again && list && list->is_structured();
  if (result.value.empty() && !is_content)
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
