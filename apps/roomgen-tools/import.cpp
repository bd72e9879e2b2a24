#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "add_commands.h"
#include "libraries.h"
#include "print.h"
#include "room_options.h"
#include "room_session.h"
#include "roomgen/base/text.h"
#include "roomgen/import/import.h"
#include "tool_commands.h"

namespace roomgen::cli {

namespace {

struct ImportCommand : RoomOptions {
  std::string file;
  bool remove_missing = false, skip_invalid = false, dry_run = false;
};

void tell_notes(const ImportCommand& command, const HandEdits& edits) {
  for (const auto& note : edits.notes) warn(note);
  if (!edits.missing.empty() && !command.remove_missing)
    warn("no node is called " + join(edits.missing, ", ") + "; they stay (--remove-missing takes them out)");
}

// The spot that an error is about: its message begins with the thing's id.
auto blamed(std::vector<edit::Arrange::Spot>& spots, const std::string& message) {
  return std::find_if(spots.begin(), spots.end(), [&](const auto& spot) { return message.starts_with(spot.object + " "); });
}

// All at once; with --skip-invalid what cannot be where it was put stays where it is.
Result<EditReport> apply_edits(const ImportCommand& command, Session& session, std::vector<edit::Operation> operations) {
  const Asker asker{"import " + command.file, command.by};
  for (;;) {
    auto report = session.apply(operations, asker);
    auto* arrange = operations.empty() ? nullptr : std::get_if<edit::Arrange>(&operations.back());
    if (report || !command.skip_invalid || !arrange) return report;
    const auto spot = blamed(arrange->spots, report.error().message);
    if (spot == arrange->spots.end()) return report;
    warn(report.error().message + "; it stays where it was");
    arrange->spots.erase(spot);
    if (arrange->spots.empty()) operations.pop_back();
    if (operations.empty()) return Error{Error::Kind::not_found, "nothing of it can be done"};
  }
}

Result<int> run_import(const Context& context, const ImportCommand& command) {
  const auto nodes = read_glb_nodes(command.file);
  if (!nodes) return nodes.error();
  const auto library = make_later_library(command.libraries, context);
  auto session = open_room(command.scene, *library,
                           {.look_only = command.dry_run, .tell = warn, .cancel = context.cancel});
  if (!session) return session.error();
  auto edits = session->compare(*nodes);
  if (!edits) return edits.error();
  tell_notes(command, *edits);
  auto operations = std::move(edits->operations);
  if (command.remove_missing && !edits->missing.empty())
    operations.insert(operations.begin(), edit::Remove{edits->missing, false});
  if (operations.empty() && !command.dry_run && !context.json) {
    std::puts("nothing is different from the room");
    return exit_ok;
  }
  if (command.dry_run || operations.empty()) {
    std::fputs(dump_json(operations_json(operations)).c_str(), stdout);
    return exit_ok;
  }
  const auto report = apply_edits(command, *session, std::move(operations));
  if (!report) return report.error();
  PictureDrawer drawer;
  if (auto status = write_room(command.scene, *session, command.no_pictures ? nullptr : &drawer, command.pixels, warn, context.cancel); !status)
    return status.error();
  if (context.json) std::fputs(dump_json(report_json(*report)).c_str(), stdout);
  else print_lines(report_lines(*report));
  return exit_ok;
}

}  // namespace

void add_import_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<ImportCommand>();
  auto* sub = add_tool_command(app, "import");
  add_scene(*sub, *command);
  sub->add_option(
         "file", command->file,
         "The .glb file; its nodes have the names of scene.glb, or its ids in their extras")
      ->required()
      ->check(CLI::ExistingFile);
  sub->add_flag("--remove-missing", command->remove_missing, "Things without a node go");
  sub->add_flag("--skip-invalid", command->skip_invalid, "What cannot stand where it was put stays where it is; the rest is done");
  sub->add_flag("--dry-run", command->dry_run, "Only print the operations");
  add_file_options(*sub, *command);
  sub->callback([command, &context] { context.run = [command, &context] { return run_import(context, *command); }; });
}

}  // namespace roomgen::cli
