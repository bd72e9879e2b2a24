#include "add_commands.h"
#include "program.h"

namespace {

void add_commands(CLI::App& app, roomgen::cli::Context& context) {
  using namespace roomgen::cli;
  add_edit_commands(app, context);
  add_import_command(app, context);
  add_design_command(app, context);
  add_repl_command(app, context);
  add_mcp_command(app, context);
}

}  // namespace

int main(int argc, char** argv) { return roomgen::cli::run_program(argc, argv, add_commands); }
