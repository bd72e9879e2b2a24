#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "command.h"
#include "libraries.h"
#include "models.h"
#include "room_files.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/render/pictures.h"
#include "roomgen/session/session.h"

namespace roomgen::cli {

namespace {

namespace fs = std::filesystem;

struct EditCommand {
  std::string scene, sentence, operation, repair = "on", by = "person";
  std::string branch;
  std::size_t steps = 1;
  std::optional<std::size_t> from, to;
  bool no_pictures = false, dry_run = false;
  int pixels = 1024;
  LibraryOptions libraries;
};

void warn(const std::string& text) { std::fprintf(stderr, "roomgen: %s\n", text.c_str()); }

/// A library that is opened when it is first asked: undo and history need none.
class LaterLibrary final : public AssetLibrary {
 public:
  LaterLibrary(const LibraryOptions& options, const Context& context) : options_(options), context_(context) {}

  Result<std::vector<AssetMatch>> search(const AssetQuery& query) const override {
    const auto& library = opened();
    if (!library) return library.error();
    return (*library)->search(query);
  }
  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override {
    const auto& library = opened();
    if (!library) return library.error();
    return (*library)->load(ref);
  }

 private:
  const Result<std::unique_ptr<AssetLibrary>>& opened() const {
    if (!library_) library_.emplace(open_all_libraries(options_, context_));
    return *library_;
  }

  const LibraryOptions& options_;
  const Context& context_;
  mutable std::optional<Result<std::unique_ptr<AssetLibrary>>> library_;
};

Result<Session> open_session(const EditCommand& command, const AssetLibrary& library, bool look_only) {
  SessionOptions options;
  options.look_only = look_only;
  options.repair = command.repair != "off";
  options.spare_models = written_models(command.scene);
  options.log = [](LogLevel, std::string_view message) { warn(std::string(message) + "; taken as a box"); };
  auto session = Session::open(command.scene, library, KindTable::built_in(), std::move(options));
  if (session)
    for (const auto& notice : session->notices()) warn(notice);
  return session;
}

bool is_followed_by(const fs::path& scene_file, const char* name) {
  std::error_code code;
  return fs::exists(scene_file.parent_path() / name, code);
}

// Those of a room's files that follow scene.json: they go unless they are written anew.
bool shows_the_room(const fs::path& relative) {
  const std::string name = relative.generic_string();
  return name == "scene.glb" || name == "ATTRIBUTION.md" || name == "top.png" || name == "iso.png" || name == "eye.png";
}

// scene.json, and what lies beside it of the room's other files. Pictures that are not drawn anew go: they
// would show the room as it was.
Status write_room(const EditCommand& command, Session& session) {
  const fs::path file = fs::absolute(command.scene);
  const bool has_models = is_followed_by(file, "scene.glb"), has_pictures = is_followed_by(file, "top.png");
  if (file.filename() != "scene.json" || (!has_models && !has_pictures)) return session.save();
  auto folder = OutputFolder::open(file.parent_path(), shows_the_room);
  if (!folder) return folder.error();
  if (auto status = folder->write("scene.json", session.text()); !status) return status;
  if (auto status = write_model_files(*folder, session.scene(), session.models()); !status) return status;
  if (has_pictures && !command.no_pictures) {
    auto renderer = make_osmesa_renderer();
    if (!renderer) return renderer.error();
    if (auto status = write_pictures(*folder, session.scene(), session.models(), **renderer, command.pixels); !status)
      return status;
  }
  if (auto status = folder->commit(); !status) return status;
  session.mark_saved();
  return {};
}

// What was acknowledged stands in the journal, whatever becomes of the files that follow it.
Status write_followers(const EditCommand& command, Session& session) {
  if (auto status = write_room(command, session); !status) {
    warn(status.error().message + "; the change is kept in the journal, and scene.json follows with the next command");
    return session.save();
  }
  return {};
}

Result<std::vector<edit::Operation>> operations_of(const EditCommand& command, const Session& session) {
  if (command.operation.empty()) return session.understand(command.sentence);
  const auto json = parse_json(command.operation, "--op");
  if (!json) return Error{Error::Kind::not_understood, json.error().message};
  auto operations = edit::operations_from_json(*json, "--op");
  if (!operations) return Error{Error::Kind::not_understood, operations.error().message};
  return operations;
}

void print_lines(const std::vector<std::string>& lines, const char* before = "") {
  for (const auto& line : lines) std::printf("%s%s\n", before, line.c_str());
}

void print_report(const Context& context, const EditReport& report) {
  if (context.json) {
    Json json = {{"state", report.state}, {"changes", report.changes}, {"added", report.added},
                 {"repairs", Json::array()}, {"broken", report.broken}};
    for (const auto& move : report.repairs) json["repairs"].push_back(to_json(move));
    std::fputs(dump_json(json).c_str(), stdout);
    return;
  }
  print_lines(report.changes);
  for (const auto& move : report.repairs)
    std::printf("%s made way by %s m\n", move.object.c_str(), format_number(move.distance(), 2).c_str());
  print_lines(report.broken);
}

Json operations_json(const std::vector<edit::Operation>& operations) {
  Json json = Json::array();
  for (const auto& operation : operations) json.push_back(edit::to_json(operation));
  return json;
}

Result<int> run_edit(const Context& context, const EditCommand& command) {
  const LaterLibrary library(command.libraries, context);
  auto session = open_session(command, library, command.dry_run);
  if (!session) return session.error();
  const auto operations = operations_of(command, *session);
  if (!operations) return operations.error();
  if (command.dry_run) {
    std::fputs(dump_json(operations_json(*operations)).c_str(), stdout);
    return exit_ok;
  }
  const std::string asked = command.sentence.empty() ? operations_json(*operations).dump() : command.sentence;
  const auto report = session->apply(*operations, {asked, command.by});
  if (!report) return report.error();
  if (auto status = write_followers(command, *session); !status) return status.error();
  print_report(context, *report);
  return exit_ok;
}

// Undo and redo.
template <typename Step>
Result<int> run_steps(const Context& context, const EditCommand& command, const char* end, Step step) {
  const LaterLibrary library(command.libraries, context);
  auto session = open_session(command, library, false);
  if (!session) return session.error();
  const Scene before = session->scene();
  const auto taken = step(*session);
  if (!taken) return taken.error();
  if (*taken == 0) {
    if (!session->is_saved())
      if (auto status = session->save(); !status) return status.error();
    return Error{Error::Kind::not_found, std::string("there is nothing to ") + end};
  }
  if (auto status = write_followers(command, *session); !status) return status.error();
  const auto changes = differences(before, session->scene());
  if (context.json) std::fputs(dump_json(Json{{"steps", *taken}, {"changes", changes}}).c_str(), stdout);
  else print_lines(changes);
  return exit_ok;
}

Json item_json(const HistoryItem& item) {
  Json json = {{"branch", item.branch}, {"by", item.by}, {"asked", item.asked}};
  if (item.state == 0) return json;
  json["state"] = item.state;
  json["parent"] = item.parent;
  json["current"] = item.is_current;
  json["undone"] = item.is_undone;
  return json;
}

Result<int> run_history(const Context& context, const EditCommand& command) {
  const LaterLibrary library(command.libraries, context);
  const auto session = open_session(command, library, true);
  if (!session) return session.error();
  Json all = Json::array();
  for (const auto& item : session->history()) {
    if (context.json) {
      all.push_back(item_json(item));
      continue;
    }
    const std::string number = item.state > 0 ? std::to_string(item.state) : "";
    std::printf("%c %4s  %s  %s: %s\n", item.is_current ? '*' : item.is_undone ? '-' : ' ', number.c_str(),
                item.branch.c_str(), item.by.c_str(), item.asked.c_str());
  }
  if (context.json) std::fputs(dump_json(all).c_str(), stdout);
  return exit_ok;
}

Result<int> run_branch(const Context& context, const EditCommand& command) {
  const LaterLibrary library(command.libraries, context);
  auto session = open_session(command, library, command.branch.empty());
  if (!session) return session.error();
  if (command.branch.empty()) {
    for (const auto& name : session->branches())
      std::printf("%c %s\n", name == session->current_branch() ? '*' : ' ', name.c_str());
    return exit_ok;
  }
  const Scene before = session->scene();
  if (auto status = session->branch(command.branch, command.from, command.by); !status) return status.error();
  if (auto status = write_followers(command, *session); !status) return status.error();
  print_lines(differences(before, session->scene()));
  return exit_ok;
}

Result<int> run_diff(const Context& context, const EditCommand& command) {
  const LaterLibrary library(command.libraries, context);
  const auto session = open_session(command, library, true);
  if (!session) return session.error();
  const auto lines = session->diff(command.from, command.to);
  if (!lines) return lines.error();
  if (context.json) std::fputs(dump_json(Json(*lines)).c_str(), stdout);
  else print_lines(*lines);
  return exit_ok;
}

using Command = std::shared_ptr<EditCommand>;

CLI::App* add_scene_command(CLI::App& app, const char* name, const char* what, const Command& command) {
  auto* sub = app.add_subcommand(name, what);
  sub->add_option("scene", command->scene, "scene.json; its journal is the .journal file beside it")->required();
  return sub;
}

void add_file_options(CLI::App& sub, EditCommand& command) {
  sub.add_option("--by", command.by, "Who asks, for the history")->capture_default_str();
  sub.add_flag("--no-pictures", command.no_pictures, "Draw no pictures; older ones go");
  sub.add_option("--pixels", command.pixels, "Length of the pictures' longer side")->capture_default_str();
  add_library_options(sub, command.libraries);
}

template <typename Run>
void run_with(CLI::App* sub, Context& context, const Command& command, Run run) {
  sub->callback([command, &context, run] { context.run = [command, &context, run] { return run(context, *command); }; });
}

void add_edit_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<EditCommand>();
  auto* sub = add_scene_command(
      app, "edit", "Change a room: exit 0 done, 1 not possible, 2 not understood; in 1 and 2 nothing changes", command);
  auto* sentence = sub->add_option("sentence", command->sentence, "What to change, in English");
  sub->add_option("--op", command->operation, "What to change, as JSON (docs/operation.schema.json)")->excludes(sentence);
  sub->add_option("--repair", command->repair, "May unlocked neighbours make way?")
      ->check(CLI::IsMember({"on", "off"}))
      ->capture_default_str();
  sub->add_flag("--dry-run", command->dry_run, "Only print the operations that the sentence means");
  add_file_options(*sub, *command);
  sub->callback([command, &context] {
    if (command->sentence.empty() && command->operation.empty())
      throw CLI::ValidationError("sentence", "say what to change, or give --op");
    context.run = [command, &context] { return run_edit(context, *command); };
  });
}

}  // namespace

void add_edit_commands(CLI::App& app, Context& context) {
  add_edit_command(app, context);

  auto undo = std::make_shared<EditCommand>();
  auto* undo_sub = add_scene_command(app, "undo", "Take back the last edits of a room", undo);
  undo_sub->add_option("-n,--steps", undo->steps, "How many")->capture_default_str();
  add_file_options(*undo_sub, *undo);
  run_with(undo_sub, context, undo, [](const Context& all, const EditCommand& command) {
    return run_steps(all, command, "undo", [&](Session& s) { return s.undo(command.steps, command.by); });
  });

  auto redo = std::make_shared<EditCommand>();
  auto* redo_sub = add_scene_command(app, "redo", "Do again what was taken back", redo);
  redo_sub->add_option("-n,--steps", redo->steps, "How many")->capture_default_str();
  add_file_options(*redo_sub, *redo);
  run_with(redo_sub, context, redo, [](const Context& all, const EditCommand& command) {
    return run_steps(all, command, "redo", [&](Session& s) { return s.redo(command.steps, command.by); });
  });

  auto history = std::make_shared<EditCommand>();
  run_with(add_scene_command(app, "history", "List the edits of a room; * is the current state", history), context,
           history, run_history);

  auto branch = std::make_shared<EditCommand>();
  auto* branch_sub = add_scene_command(app, "branch", "List the branches of a room's history, or go to one", branch);
  branch_sub->add_option("name", branch->branch, "A new branch begins here, or at --at");
  branch_sub->add_option("--at", branch->from, "The state at which a new branch begins");
  add_file_options(*branch_sub, *branch);
  run_with(branch_sub, context, branch, run_branch);

  auto diff = std::make_shared<EditCommand>();
  auto* diff_sub = add_scene_command(app, "diff", "Say what is different between two states of a room", diff);
  diff_sub->add_option("from", diff->from, "A state (see history); the one before unless given");
  diff_sub->add_option("to", diff->to, "A later one; the current one unless given");
  run_with(diff_sub, context, diff, run_diff);
}

}  // namespace roomgen::cli
