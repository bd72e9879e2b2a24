#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "add_commands.h"
#include "any_plan.h"
#include "check_report.h"
#include "models.h"
#include "print.h"
#include "program_format.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/design/designer.h"
#include "roomgen/evaluate/report.h"
#include "roomgen/import/import.h"
#include "roomgen/scene/plan.h"
#include "roomgen/scene/problem.h"
#include "roomgen/shape/evaluate.h"
#include "roomgen/shape/program.h"
#include "samples.h"
#include "tool_commands.h"

namespace roomgen::cli {

namespace {

struct CheckCommand {
  std::string file;
  std::string varied;  ///< what layouts were drawn from
  ModelOptions models;
};

Result<int> check_scene(const Context& context, const CheckCommand& command, const Scene& scene) {
  auto models = models_of(scene, command.file, command.models, context);
  if (!models) return models.error();
  const auto report = examine(scene, *models, KindTable::built_in());
  if (context.json) {
    std::fputs(dump_json(check_json(scene, report)).c_str(), stdout);
  } else {
    std::printf("%s: %s\n", printable(command.file).c_str(), printable(check_headline(scene, report)).c_str());
    print_lines(check_lines(scene, report));
  }
  return report.violations.empty() ? exit_ok : exit_failure;
}

// With default parameters.
Result<std::string> check_shape(const CheckCommand& command, const Json& json) {
  const auto folder = std::filesystem::path(command.file).parent_path();
  const auto program = shape::instantiate(json, {}, 0, shape::recipes_in(folder), command.file);
  if (!program) return program.error();
  const auto made = shape::evaluate_within(*program);
  if (!made) return with_context(made.error(), command.file);
  return "shape of " + std::to_string(made->bodies.size()) + " bodies";
}

void print_sound(const Context& context, const std::string& file, const std::string& what,
                 const std::vector<std::string>& notes = {}) {
  if (context.json) {
    Json summary = {{"file", file}, {"sound", what}};
    if (!notes.empty()) summary["notes"] = notes;
    std::fputs(dump_json(summary).c_str(), stdout);
  } else {
    std::printf("%s: sound %s\n", printable(file).c_str(), printable(what).c_str());
    for (const auto& note : notes) std::printf("  %s\n", printable(note).c_str());
  }
}

std::string floor_plan_text(const Room& room) {
  return "room with " + std::to_string(room.polygon.size()) + " walls, " +
         format_number(area(room.polygon), 2) + " m2";
}

Result<std::string> check_problem(const CheckCommand& command, const Json& json,
                                  const std::string& format) {
  if (!format.empty() && format != "roomgen-problem")
    return Error{Error::Kind::invalid_input,
                 command.file + ": /format: \"" + format + "\" is none that is checked; scenes, " +
                     "plans, problems, rooms, designs, shapes, programs and layouts are"};
  const auto problem = problem_from_json(json, command.file);
  if (!problem) return problem.error();
  return "problem of " + std::to_string(problem->tasks.size()) + " objects";
}

// A document without a format is a problem if it has what problems have, else a room.
Result<int> check_other(const Context& context, const CheckCommand& command, const Json& json) {
  const std::string format =
      json.is_object() && json.contains("format") && json["format"].is_string()
          ? json["format"].get<std::string>()
          : "";
  std::string what;
  std::vector<std::string> notes;
  if (format == "roomgen-plan" && is_dwelling_plan(json)) {
    auto plan = dwelling_plan_from_json(json, command.file);
    if (!plan) return plan.error();
    what = "plan of " + std::to_string(plan->rooms.size()) + " rooms";
    settle(*plan);
    notes = notes_of(*std::move(plan));
  } else if (format == "roomgen-plan") {
    auto plan = plan_from_json(json, command.file);
    if (!plan) return plan.error();
    what = "plan of " + std::to_string(planned_objects(*plan).size()) + " objects";
    settle(*plan);
    notes = notes_of(*std::move(plan));
  } else if (format == "roomgen-design") {
    auto design = check_design(json, command.file);
    if (!design) return design.error();
    what = *design;
  } else if (format == "roomgen-shape") {
    auto shape = check_shape(command, json);
    if (!shape) return shape.error();
    what = *shape;
  } else if (json.is_object() && json.contains("polygon")) {
    auto room = read_room_file(command.file);
    if (!room) return room.error();
    what = floor_plan_text(*room);
  } else {
    auto problem = check_problem(command, json, format);
    if (!problem) return problem.error();
    what = *problem;
  }
  print_sound(context, command.file, what, notes);
  return exit_ok;
}

// A drawing has no format of ours; its name says what it is.
bool is_drawing(const std::filesystem::path& path) {
  const std::string ending = lower(path.extension().string());
  return ending == ".svg" || ending == ".dxf";
}

// One a line.
bool are_layouts(const std::filesystem::path& path) { return lower(path.extension().string()) == ".jsonl"; }

Result<int> check_drawing(const Context& context, const CheckCommand& command) {
  const auto room = read_floor_plan(command.file);
  if (!room) return room.error();
  print_sound(context, command.file, floor_plan_text(*room));
  return exit_ok;
}

Result<int> run(const Context& context, const CheckCommand& command) {
  if (is_drawing(command.file)) return check_drawing(context, command);
  if (are_layouts(command.file)) return check_samples(context, command.file, command.varied, command.models);
  auto text = read_file(command.file);
  if (!text) return text.error();
  auto json = parse_json(*text, command.file);
  if (!json) return json.error();
  if (json->is_object() && json->contains("format") && (*json)["format"] == "roomgen-scene") {
    auto scene = scene_from_json(*json, command.file);
    if (!scene) return scene.error();
    return check_scene(context, command, *scene);
  }
  if (is_constraint_program(*json)) return hand_over_check(command.file, context.json);
  return check_other(context, command, *json);
}

}  // namespace

void add_check_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<CheckCommand>();
  auto* sub = app.add_subcommand("check",
                                 "Check a scene, plan, problem, room, design, shape or program "
                                 "file, a drawing of a floor plan, or layouts; exit 1 if "
                                 "a scene or layout breaks a rule or a program has errors");
  sub->add_option("file", command->file, "JSON, SVG or DXF file, or layouts in a .jsonl file")->required();
  sub->add_option("--of", command->varied, "The problem or scene that layouts were drawn from");
  add_model_options(*sub, command->models);
  sub->callback([command, &context] {
    context.run = [command, &context] { return run(context, *command); };
  });
}

}  // namespace roomgen::cli
