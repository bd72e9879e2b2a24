#include <string_view>

#include "add_commands.h"
#include "program.h"
#include "tool_commands.h"

namespace {

using namespace roomgen::cli;

void add_commands(CLI::App& app, Context& context) {
#if defined(ROOMGEN_HAS_ASSETS) && defined(ROOMGEN_HAS_RENDER)
  add_generate_command(app, context);
  add_create_command(app, context);
#endif
  add_plan_command(app, context);
  add_solve_command(app, context);
  add_check_command(app, context);
#ifdef ROOMGEN_HAS_RENDER
  add_render_command(app, context);
  add_export_command(app, context);
#endif
#ifdef ROOMGEN_HAS_ASSETS
  add_assets_command(app, context);
#endif
  list_tool_commands(app);
}

// Options before the command are flags, so the first word is the command.
std::string_view command_of(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (argv[i][0] != '-') return argv[i];
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view command = command_of(argc, argv);
  if (is_tool_command(command)) return hand_over(command, argv);
  return run_program(argc, argv, add_commands);
}
