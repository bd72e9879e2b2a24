#include <nlohmann/json.hpp>

#include "arguments.h"
#include "check_report.h"
#include "room_files.h"
#include "roomgen/generate/generate.h"
#include "summary.h"
#include "tools.h"

namespace roomgen::mcp {

namespace {

Result<cli::AnyPlan> wanted_plan(const Workplace& place, const ToolCall& call, Designer& designer) {
  const bool has_prompt = call.arguments.contains("prompt");
  if (has_prompt == call.arguments.contains("plan"))
    return Error{Error::Kind::invalid_input, "generate: give either prompt or plan"};
  if (!has_prompt) {
    const auto file = place.root.find(call.arguments["plan"].get<std::string>());
    if (!file) return with_context(file.error(), "/plan");
    return cli::read_any_plan(file->string());
  }
  const auto wish = plan_wish(place, call.arguments);
  if (!wish) return wish.error();
  return cli::make_plan(*wish, designer, call.cancel);
}

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
  options.tells_least = call.arguments.contains("plan") || !std::holds_alternative<Plan>(plan);
  options.on_event = [&call](const BuildEvent& event) {
    call.progress(how_far(event), static_cast<double>(event.total + 1), in_words(event));
  };
  return std::visit(
      [&](const auto& each) { return generate(each, designer, place.library, KindTable::built_in(), options); }, plan);
}

Error with_least(const Workplace& place, const ToolCall& call, const Error& error,
                 const cli::AnyPlan* plan) {
  const auto wish = call.arguments.contains("prompt") ? plan_wish(place, call.arguments)
                                                      : Result<cli::PlanWish>(error);
  BuildOptions options;
  options.cancel = call.cancel;
  if (wish) options.seed = wish->seed;
  return wish ? cli::told_with_least_size(error, *wish, plan, place.library, options) : error;
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

Result<ToolAnswer> make_room(Workplace& place, const ToolCall& call) {
  const auto folder = new_room_folder(place, call.arguments);
  if (!folder) return folder.error();
  const auto designer = make_rule_designer();
  const auto plan = wanted_plan(place, call, *designer);
  if (!plan) return with_least(place, call, plan.error(), nullptr);
  auto output = open_room_folder(*folder, false);
  if (!output) return output.error();
  const auto made = furnish(place, call, *plan, *designer);
  if (!made) return with_least(place, call, made.error(), &*plan);
  if (call.cancel.cancelled()) return Error{Error::Kind::cancelled, "stopped; nothing was written"};
  cli::PictureDrawer* drawer = place.keeps_pictures ? &place.drawer : nullptr;
  if (auto status = cli::write_new_room(*output, cli::plan_json(*plan), *made, drawer, kept_pixels); !status)
    return status.error();
  if (auto status = output->commit(); !status) return status.error();
  const std::string name = place.root.name_of(*folder);
  std::vector<std::string> lines = {name + ": " + cli::headline(made->scene)};
  for (const auto& each : {cli::note_lines(*plan, *made), cli::lack_lines(made->scene)})
    lines.insert(lines.end(), each.begin(), each.end());
  ToolAnswer answer = text_answer(text_of(lines), answer_json(name, *made));
  add_wanted_picture(place, made->scene, made->models, call, answer);
  return answer;
}

}  // namespace

Tool generate_tool(Workplace& place) {
  return [&place](const ToolCall& call) { return make_room(place, call); };
}

}  // namespace roomgen::mcp
