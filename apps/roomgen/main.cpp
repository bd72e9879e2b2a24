#include <csignal>
#include <cstdio>

#include "command.h"

namespace {

roomgen::CancelToken* interrupted = nullptr;

// The first Ctrl-C asks the work to stop with what is whole; a second one ends the program.
void on_interrupt(int signal) {
  if (interrupted && !interrupted->cancelled()) return interrupted->cancel();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

int exit_code_of(const roomgen::Error& error) {
  switch (error.kind) {
    case roomgen::Error::Kind::cancelled:
      return roomgen::cli::exit_interrupted;
    case roomgen::Error::Kind::not_understood:
      return roomgen::cli::exit_usage;
    default:
      return roomgen::cli::exit_failure;
  }
}

}  // namespace

int main(int argc, char** argv) {
  using namespace roomgen::cli;
  Context context;
  CLI::App app("roomgen furnishes 3D rooms from a sentence.", "roomgen");
  app.set_version_flag("--version", std::string("roomgen ") + ROOMGEN_VERSION);
  app.require_subcommand(1);
  app.fallthrough();
  app.add_flag("--json", context.json, "Print a summary for scripts");
  app.add_flag("--quiet", context.quiet, "No progress");
  add_solve_command(app, context);
  add_check_command(app, context);
  add_evaluate_command(app, context);
  add_plan_command(app, context);
#ifdef ROOMGEN_HAS_ASSETS
  add_assets_command(app, context);
#endif
#ifdef ROOMGEN_HAS_RENDER
  add_export_command(app, context);
  add_render_command(app, context);
  add_tour_command(app, context);
  add_frames_command(app, context);
  add_questions_command(app, context);
#endif
#if defined(ROOMGEN_HAS_ASSETS) && defined(ROOMGEN_HAS_RENDER)
  add_create_command(app, context);
  add_generate_command(app, context);
  add_optimise_command(app, context);
  add_compose_command(app, context);
  add_edit_commands(app, context);
  add_import_command(app, context);
  add_repl_command(app, context);
  add_mcp_command(app, context);
  add_experiment_command(app, context);
  add_benchmark_command(app, context);
#endif

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    std::fprintf(stderr, "roomgen: %s\n", error.what());
    return exit_usage;
  }

  interrupted = &context.cancel;
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  const auto result = context.run();
  if (result) return *result;
  std::fprintf(stderr, "roomgen: %s\n", result.error().message.c_str());
  return exit_code_of(result.error());
}
