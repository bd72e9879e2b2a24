#include <nlohmann/json.hpp>

#include "agent_design.h"
#include "arguments.h"
#include "check_report.h"
#include "room_files.h"
#include "roomgen/generate/generate.h"
#include "summary.h"
#include "tools.h"

namespace roomgen::mcp {

namespace {

// Between two things that were tried, so that each event is further than the one before.
double how_far(const BuildEvent& event) {
  using Kind = BuildEvent::Kind;
  const auto done = static_cast<double>(event.done);
  if (event.kind == Kind::begun) return done + 0.25;
  if (event.kind == Kind::improving) return done + 0.5;
  return event.kind == Kind::improved ? done + 0.75 : done;
}

std::string in_words(const BuildEvent& event) {
  using Kind = BuildEvent::Kind;
  if (event.kind == Kind::begun) return "placing " + event.object;
  if (event.kind == Kind::placed) return event.object + " stands";
  if (event.kind == Kind::left_out) return event.object + " found no place";
  return event.kind == Kind::improving ? "improving the room" : "the room is improved";
}

Result<Generation> furnish(const Workplace& place, const ToolCall& call, const cli::AnyPlan& plan, Designer& designer) {
  BuildOptions options;
  options.seed = std::visit([](const auto& each) { return each.seed; }, plan);
  options.cancel = call.cancel;
  options.tells_least = !call.arguments.contains("prompt") || call.arguments.contains("design") ||
                        !std::holds_alternative<Plan>(plan);
  options.on_event = [&call](const BuildEvent& event) {
    call.progress(how_far(event), static_cast<double>(event.total + 1), in_words(event));
  };
  return std::visit(
      [&](const auto& each) { return generate(each, designer, *place.library, KindTable::built_in(), options); }, plan);
}

Error with_least(const Workplace& place, const ToolCall& call, const Error& error,
                 const cli::AnyPlan* plan) {
  const bool is_by_rules = call.arguments.contains("prompt") && !call.arguments.contains("design");
  const auto wish = is_by_rules ? plan_wish(place, call.arguments) : Result<cli::PlanWish>(error);
  BuildOptions options;
  options.cancel = call.cancel;
  if (wish) options.seed = wish->seed;
  return wish ? cli::told_with_least_size(error, *wish, plan, *place.library, options) : error;
}

bool is_designed(const Json& arguments) {
  return arguments.contains("choices") || arguments.contains("places");
}

Json answer_json(const std::string& name, const Generation& made) {
  const Scene& scene = made.scene;
  const cli::Clauses clauses = cli::clauses_of(scene);
  Json json = {{"room", name},
               {"objects", scene.objects.size()},
               {"asked", clauses.asked},
               {"met", clauses.met},
               {"not_met", clauses.unmet},
               {"not_understood", not_understood(scene)},
               {"left_out", Json::array()},
               {"notes", made.notes},
               {"incomplete", scene.incomplete}};
  for (const auto& missing : scene.unplaced) json["left_out"].push_back(missing.id + ": " + missing.reason);
  return json;
}

}  // namespace

Result<ToolAnswer> generate_room(Workplace& place, const ToolCall& call) {
  const auto folder = new_room_folder(place, call.arguments);
  if (!folder) return folder.error();
  AgentDesign agent = agent_design(call.arguments, false);
  const auto plan = wanted_plan(place, call, agent);
  if (!plan) return with_least(place, call, plan.error(), nullptr);
  auto output = open_room_folder(*folder, false);
  if (!output) return output.error();
  const auto rules = make_rule_designer();
  auto made = furnish(place, call, *plan, is_designed(call.arguments) ? *agent.designer : *rules);
  if (!made) return with_least(place, call, made.error(), &*plan);
  for (const auto& notes : {notes_on_answers(call.arguments, *made), cli::notes_of(*plan)})
    made->notes.insert(made->notes.begin(), notes.begin(), notes.end());
  if (call.cancel.cancelled()) return Error{Error::Kind::cancelled, "stopped; nothing was written"};
  cli::PictureDrawer* drawer = place.keeps_pictures ? &place.drawer : nullptr;
  if (auto status = cli::write_new_room(*output, cli::plan_json(*plan, *made), *made, drawer, kept_pixels); !status)
    return status.error();
  if (auto status = output->commit(); !status) return status.error();
  const std::string name = place.root.name_of(*folder);
  std::vector<std::string> lines = {name + ": " + cli::headline(made->scene)};
  for (const auto& note : made->notes) lines.push_back("note: " + note);
  for (auto& lack : cli::lack_lines(made->scene)) lines.push_back(std::move(lack));
  ToolAnswer answer = text_answer(text_of(lines), answer_json(name, *made));
  add_wanted_picture(place, made->scene, made->models, call, answer);
  return answer;
}

}  // namespace roomgen::mcp
