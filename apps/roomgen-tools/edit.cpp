#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "add_commands.h"
#include "designers.h"
#include "libraries.h"
#include "print.h"
#include "room_options.h"
#include "room_session.h"
#include "roomgen/base/json.h"
#include "roomgen/edit/session.h"
#include "roomgen/edit_reader/understand.h"
#include "tool_commands.h"
#include "views.h"

namespace roomgen::cli {

namespace {

struct EditCommand : RoomOptions {
  std::string sentence, operation, branch;
  std::size_t steps = 1;
  std::optional<std::size_t> from, to;
  bool dry_run = false;
  DesignerOptions designer;
};

Result<Session> open_session(const Context& context, const EditCommand& command, const AssetLibrary& library, bool look_only) {
  return open_room(command.scene, library, {.look_only = look_only, .repair = command.may_repair(), .tell = warn, .cancel = context.cancel});
}

Status write_followers(const Context& context, const EditCommand& command, Session& session) {
  PictureDrawer drawer;
  return write_room(command.scene, session, command.no_pictures ? nullptr : &drawer, command.pixels, warn, context.cancel);
}

Result<Understanding> understood_by_wish(const Context& context, const EditCommand& command,
                                         Session& session) {
  if (!command.designer.reads_by_model()) return understand(session, command.sentence);
  const auto composed = compose_model(command.designer, context, cache_folder(command.libraries));
  if (!composed) return composed.error();
  PictureDrawer drawer;
  auto pictures = pictures_for_model(command.designer, drawer, session, {"marks"}, command.pixels);
  if (!pictures) return pictures.error();
  return understand(session, command.sentence,
                            {.model = *composed->model, .prompts = composed->prompts, .pictures = *std::move(pictures), .cancel = context.cancel});
}

Result<std::vector<edit::Operation>> operations_of(const Context& context, const EditCommand& command, Session& session) {
  if (command.operation.empty()) {
    auto understood = understood_by_wish(context, command, session);
    if (!understood) return understood.error();
    for (const auto& remark : understood->remarks) warn(remark_line(remark));
    return std::move(understood->operations);
  }
  const auto json = parse_json(command.operation, "--op");
  if (!json) return Error{Error::Kind::not_understood, json.error().message};
  auto operations = edit::operations_from_json(*json, "--op");
  if (!operations) return Error{Error::Kind::not_understood, operations.error().message};
  return operations;
}

void print_report(const Context& context, const EditReport& report) {
  if (context.json) std::fputs(dump_json(report_json(report)).c_str(), stdout);
  else print_lines(report_lines(report));
}

Result<int> run_edit(const Context& context, const EditCommand& command) {
  const auto library = make_later_library(command.libraries, context);
  auto session = open_session(context, command, *library, command.dry_run);
  if (!session) return session.error();
  const auto operations = operations_of(context, command, *session);
  if (!operations) return operations.error();
  if (command.dry_run) {
    std::fputs(dump_json(operations_json(*operations)).c_str(), stdout);
    return exit_ok;
  }
  const std::string asked = command.sentence.empty() ? operations_json(*operations).dump() : command.sentence;
  const auto report = session->apply(*operations, {asked, command.by});
  if (!report) return report.error();
  if (auto status = write_followers(context, command, *session); !status) return status.error();
  print_report(context, *report);
  return exit_ok;
}

using Steps = Result<std::size_t> (Session::*)(std::size_t steps, const std::string& by);

// Undo and redo.
Result<int> run_steps(const Context& context, const EditCommand& command, const char* name, Steps take) {
  const auto library = make_later_library(command.libraries, context);
  auto session = open_session(context, command, *library, false);
  if (!session) return session.error();
  const Scene before = session->scene();
  const auto taken = ((*session).*take)(command.steps, command.by);
  if (!taken) return taken.error();
  if (*taken == 0) {
    if (!session->is_saved())
      if (auto status = session->save(); !status) return status.error();
    return Error{Error::Kind::not_found, std::string("there is nothing to ") + name};
  }
  if (auto status = write_followers(context, command, *session); !status) return status.error();
  const auto changes = differences(before, session->scene());
  if (context.json) std::fputs(dump_json(Json{{"steps", *taken}, {"changes", changes}}).c_str(), stdout);
  else print_lines(changes);
  return exit_ok;
}

Result<int> run_history(const Context& context, const EditCommand& command) {
  const auto library = make_later_library(command.libraries, context);
  const auto session = open_session(context, command, *library, true);
  if (!session) return session.error();
  if (context.json) std::fputs(dump_json(history_json(*session)).c_str(), stdout);
  else print_lines(history_lines(*session));
  return exit_ok;
}

Result<int> run_branch(const Context& context, const EditCommand& command) {
  const auto library = make_later_library(command.libraries, context);
  auto session = open_session(context, command, *library, command.branch.empty());
  if (!session) return session.error();
  if (command.branch.empty()) {
    for (const auto& name : session->branches())
      std::printf("%c %s\n", name == session->current_branch() ? '*' : ' ', printable(name).c_str());
    return exit_ok;
  }
  const Scene before = session->scene();
  if (auto status = session->branch(command.branch, command.from, command.by); !status) return status.error();
  if (auto status = write_followers(context, command, *session); !status) return status.error();
  const auto changes = differences(before, session->scene());
  if (context.json) std::fputs(dump_json(Json{{"branch", session->current_branch()}, {"changes", changes}}).c_str(), stdout);
  else {
    std::printf("on branch %s\n", printable(session->current_branch()).c_str());
    if (!changes.empty()) print_lines(changes);
  }
  return exit_ok;
}

Result<int> run_diff(const Context& context, const EditCommand& command) {
  const auto library = make_later_library(command.libraries, context);
  const auto session = open_session(context, command, *library, true);
  if (!session) return session.error();
  const auto lines = session->diff(command.from, command.to);
  if (!lines) return lines.error();
  if (context.json) std::fputs(dump_json(Json(*lines)).c_str(), stdout);
  else print_lines(*lines);
  return exit_ok;
}

using Command = std::shared_ptr<EditCommand>;

CLI::App* add_scene_command(CLI::App& app, const char* name, const Command& command) {
  auto* sub = add_tool_command(app, name);
  add_scene(*sub, *command);
  return sub;
}

template <typename Run>
void run_with(CLI::App* sub, Context& context, const Command& command, Run run) {
  sub->callback([command, &context, run] { context.run = [command, &context, run] { return run(context, *command); }; });
}

void add_edit_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<EditCommand>();
  auto* sub = add_scene_command(app, "edit", command);
  auto* sentence = sub->add_option("sentence", command->sentence, "What to change, in English");
  sub->add_option("--op", command->operation, "What to change, as JSON (docs/operation.schema.json)")->excludes(sentence);
  add_repair_option(*sub, *command);
  sub->add_flag("--dry-run", command->dry_run, "Only print the operations that the sentence means");
  add_file_options(*sub, *command);
  add_chat_options(*sub, command->designer);
  add_reader_option(*sub, command->designer);
  sub->callback([command, &context] {
    if (command->sentence.empty() && command->operation.empty())
      throw CLI::ValidationError("sentence", "say what to change, or give --op");
    context.run = [command, &context] { return run_edit(context, *command); };
  });
}

void add_steps_command(CLI::App& app, Context& context, const char* name, Steps take) {
  auto command = std::make_shared<EditCommand>();
  auto* sub = add_scene_command(app, name, command);
  sub->add_option("-n,--steps", command->steps, "How many")->capture_default_str();
  add_file_options(*sub, *command);
  run_with(sub, context, command, [name, take](const Context& all, const EditCommand& one) {
    return run_steps(all, one, name, take);
  });
}

}  // namespace

void add_edit_commands(CLI::App& app, Context& context) {
  add_edit_command(app, context);

  add_steps_command(app, context, "undo", &Session::undo);
  add_steps_command(app, context, "redo", &Session::redo);

  auto history = std::make_shared<EditCommand>();
  run_with(add_scene_command(app, "history", history), context, history, run_history);

  auto branch = std::make_shared<EditCommand>();
  auto* branch_sub = add_scene_command(app, "branch", branch);
  branch_sub->add_option("name", branch->branch, "A new branch begins here, or at --at");
  branch_sub->add_option("--at", branch->from, "The state at which a new branch begins");
  add_file_options(*branch_sub, *branch);
  run_with(branch_sub, context, branch, run_branch);

  auto diff = std::make_shared<EditCommand>();
  auto* diff_sub = add_scene_command(app, "diff", diff);
  diff_sub->add_option("from", diff->from, "A state (see history); the one before unless given");
  diff_sub->add_option("to", diff->to, "A later one; the current one unless given");
  run_with(diff_sub, context, diff, run_diff);
}

}  // namespace roomgen::cli
