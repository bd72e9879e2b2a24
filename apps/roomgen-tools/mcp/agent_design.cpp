#include "agent_design.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "arguments.h"
#include "roomgen/base/text.h"
#include "roomgen/render/pictures.h"

namespace roomgen::mcp {

namespace {

Error invalid(const std::string& message) { return {Error::Kind::invalid_input, message}; }

// "side-table-0" means "side table-0".
std::string with_blanks(std::string id) {
  const auto number = id.rfind('-');
  for (std::size_t i = 0; number != id.npos && i < number; ++i)
    if (id[i] == '-') id[i] = ' ';
  return id;
}

std::string id_of(const Json& place) { return lower(place["id"].get<std::string>()); }

// Names of things, as a design of nothing else.
Json design_of(const Json& things) {
  Json objects = Json::array();
  for (const auto& thing : things)
    objects.push_back({{"name", thing}, {"description", thing}, {"quantity", 1}});
  return {{"room", {{"type", "room"}}}, {"objects", std::move(objects)}};
}

bool is_own(const Json& arguments) {
  return arguments.contains("design") || arguments.contains("things");
}

Result<cli::AnyPlan> own_plan(const cli::PlanWish& wish, const ToolCall& call, AgentDesign& agent) {
  auto plan = cli::make_plan(wish, *agent.designer, call.cancel, agent.reader.get());
  if (!plan) return plan;
  if (std::holds_alternative<DwellingPlan>(*plan))
    return invalid("/design: a design is of one room, and the prompt asks for several; "
                   "generate each into a folder of its own");
  const Consultation how = agent.designer->plan_consultation();
  if (how.fell_back)
    return invalid("/design: " + join(how.notes, "; ") +
                   " (its form: roomgen:///docs/plan-form.md)");
  return plan;
}

}  // namespace

Result<ChatReply> GivenAnswers::chat(const ChatRequest& request) {
  if (auto found = answers.extract(request.schema_name)) return ChatReply{found.mapped()};
  if (!asked) asked = request;
  return Error{Error::Kind::io, "the agent has not said so; rules decide"};
}

AgentDesign agent_design(const Json& arguments, bool chooses) {
  AgentDesign agent;
  auto& answers = agent.given->answers;
  if (arguments.contains("brief")) answers["brief"] = arguments["brief"].dump();
  if (arguments.contains("design")) answers["plan"] = arguments["design"].dump();
  if (arguments.contains("things")) answers["plan"] = design_of(arguments["things"]).dump();
  if (arguments.contains("choices"))
    answers["choices"] = Json{{"choices", arguments["choices"]}}.dump();
  const Prompts prompts = Prompts::built_in();
  if (arguments.contains("brief"))
    agent.reader = make_model_reader(*agent.given, prompts, KindTable::built_in(),
                                     {.answers = 1, .no_fallback = true});
  ModelDesignerOptions options;
  options.answers = 1;
  options.chooses_assets = chooses || arguments.contains("choices");
  options.encode_picture = [](const Image& image) { return encode_jpeg(image, 80); };
  for (const auto& place : arguments.value("places", Json::array()))
    options.places[id_of(place)] = options.places[with_blanks(id_of(place))] = place.dump();
  agent.designer = make_model_designer(*agent.given, make_rule_designer(), prompts,
                                       KindTable::built_in(), std::move(options));
  return agent;
}

Result<cli::AnyPlan> wanted_plan(const Workplace& place, const ToolCall& call, AgentDesign& agent) {
  const Json& arguments = call.arguments;
  const bool has_wish = arguments.contains("prompt") || arguments.contains("things");
  const bool is_twice = arguments.contains("plan") && (has_wish || arguments.contains("design"));
  if (is_twice || (!has_wish && !arguments.contains("plan")))
    return invalid("give either prompt or plan (the path of one that was saved); "
                   "a design goes with a prompt");
  if (!has_wish) {
    const auto file = place.root.find(arguments["plan"].get<std::string>());
    if (!file) return with_context(file.error(), "/plan");
    return cli::read_any_plan(file->string());
  }
  const auto wish = plan_wish(place, arguments);
  if (!wish) return wish.error();
  if (is_own(arguments)) return own_plan(*wish, call, agent);
  return cli::make_plan(*wish, *make_rule_designer(), call.cancel, agent.reader.get());
}

std::vector<std::string> notes_on_answers(const Json& arguments, const Generation& made) {
  std::vector<std::string> notes;
  for (const auto& round : made.choices)
    for (const auto& note : round.answer.consultation.notes) notes.push_back(note);
  for (const auto& place : arguments.value("places", Json::array())) {
    const std::string id = id_of(place);
    const auto step = std::find_if(made.trace.begin(), made.trace.end(), [&](const Step& one) {
      return with_blanks(one.planned.id) == with_blanks(id);
    });
    if (step == made.trace.end())
      notes.push_back(id + ": the plan has no such thing; candidates lists the ids");
    if (step == made.trace.end() || step->attempts.empty()) continue;
    const Attempt& first = step->attempts.front();
    std::vector<std::string> what;
    if (!first.refused.empty()) what.push_back(first.refused + "; it went elsewhere");
    for (const auto& note : first.answer.consultation.notes)
      if (note != "answered together with others") what.push_back(note);
    if (!what.empty()) notes.push_back(id + ": " + join(what, "; "));
  }
  return notes;
}

}  // namespace roomgen::mcp
