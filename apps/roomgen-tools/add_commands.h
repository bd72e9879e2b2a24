#pragma once

#include "command.h"

namespace roomgen::cli {

// One function a command, each in a file of its name.
/// edit, undo, redo, history, branch and diff.
void add_edit_commands(CLI::App& app, Context& context);
/// Poses changed in another program.
void add_import_command(CLI::App& app, Context& context);
/// Designs from finished rooms.
void add_design_command(CLI::App& app, Context& context);
void add_repl_command(CLI::App& app, Context& context);
void add_mcp_command(CLI::App& app, Context& context);

}  // namespace roomgen::cli
