#include <nlohmann/json.hpp>

#include "agent_design.h"
#include "arguments.h"
#include "roomgen/base/text.h"
#include "roomgen/generate/room_builder.h"
#include "tools.h"

namespace roomgen::mcp {

namespace {

// What a model is asked about it.
std::string question_of(const AgentDesign& agent) {
  return agent.given->asked->messages.back().text;
}

std::vector<Plan> rooms_of(const cli::AnyPlan& plan) {
  const auto* dwelling = std::get_if<DwellingPlan>(&plan);
  return dwelling ? dwelling->rooms : std::vector<Plan>{std::get<Plan>(plan)};
}

Json requirements_of(const cli::AnyPlan& plan) {
  Json json = Json::array();
  for (const auto& room : rooms_of(plan))
    for (const auto& one : room.requirements) json.push_back(to_json(one));
  return json;
}

// Without what rules note for themselves.
void keep_said(Json& brief) {
  if (brief.is_object())
    for (const char* key : {"rules", "format", "version", "wish"}) brief.erase(key);
  for (auto& member : brief)
    if (member.is_structured()) keep_said(member);
}

}  // namespace

Result<ToolAnswer> read_wish(Workplace& place, const ToolCall& call) {
  const auto wish = plan_wish(place, call.arguments);
  if (!wish) return wish.error();
  auto request = cli::request_of(*wish, call.cancel);
  if (!request) return request.error();
  AgentDesign reading = agent_design(call.arguments, false);
  AgentDesign agent = agent_design(call.arguments, false);
  if (reading.reader)
    if (auto read = reading.reader->read(*request); !read)
      return with_context(read.error(), "/brief");
  auto brief = brief_json(*request);
  if (!brief) return brief.error();
  keep_said(*brief);
  auto plan = cli::make_plan(*wish, *agent.designer, call.cancel, agent.reader.get());
  if (!plan && !agent.given->asked) return plan.error();
  Json data = {{"brief", *brief}, {"notes", Json::array()}};
  if (reading.reader) data["notes"] = reading.reader->consultation().notes;
  if (plan) data["requirements"] = requirements_of(*plan);
  std::string text = question_of(agent) + "\nThe reading, for brief: " + json_line(*brief);
  for (const auto& note : data["notes"]) text += "\nnote: " + note.get<std::string>();
  return text_answer(text, std::move(data));
}

Result<ToolAnswer> list_candidates(Workplace& place, const ToolCall& call) {
  AgentDesign agent = agent_design(call.arguments, true);
  const auto plan = wanted_plan(place, call, agent);
  if (!plan) return plan.error();
  if (!std::holds_alternative<Plan>(*plan))
    return Error{Error::Kind::invalid_input,
                 "candidates are those of one room; ask for each room by itself"};
  BuildOptions options;
  options.seed = std::get<Plan>(*plan).seed;
  options.cancel = call.cancel;
  const auto renderer = place.drawer.renderer();
  if (renderer) options.renderer = *renderer;
  agent.given->asked.reset();
  const auto begun = RoomBuilder::begin(std::get<Plan>(*plan), *agent.designer, *place.library,
                                        KindTable::built_in(), options);
  if (!begun) return begun.error();
  if (!agent.given->asked) return text_answer("There is nothing to choose.");
  const auto& pictures = agent.given->asked->messages.back().images;
  const auto page = call.arguments.value("page", std::size_t{1});
  std::string text = question_of(agent);
  for (const auto& note : cli::notes_of(*plan)) text += "note: " + note + "\n";
  std::vector<std::string> ids;
  for (const auto& planned : planned_objects(std::get<Plan>(*plan))) ids.push_back(planned.id);
  text += "Ids, for places: " + join(ids, ", ");
  if (pictures.size() > 1)
    text += "\nPicture " + std::to_string(page) + " of " + std::to_string(pictures.size()) +
            "; page shows another one.";
  ToolAnswer answer = text_answer(text);
  if (page <= pictures.size()) add_picture(answer, pictures[page - 1]);
  return answer;
}

}  // namespace roomgen::mcp
