#pragma once

#include "command.h"

namespace roomgen::cli {

// One function a command, each in a file of its name.
void add_solve_command(CLI::App& app, Context& context);
void add_check_command(CLI::App& app, Context& context);
void add_plan_command(CLI::App& app, Context& context);
void add_assets_command(CLI::App& app, Context& context);
void add_export_command(CLI::App& app, Context& context);
void add_render_command(CLI::App& app, Context& context);
void add_create_command(CLI::App& app, Context& context);
void add_generate_command(CLI::App& app, Context& context);

}  // namespace roomgen::cli
