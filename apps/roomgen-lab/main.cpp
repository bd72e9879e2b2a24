#include "add_commands.h"
#include "program.h"

namespace {

void add_commands(CLI::App& app, roomgen::cli::Context& context) {
  using namespace roomgen::cli;
  add_check_command(app, context);
  add_compose_command(app, context);
  add_optimise_command(app, context);
  add_tour_command(app, context);
  add_frames_command(app, context);
  add_questions_command(app, context);
  add_benchmark_command(app, context);
  add_experiment_command(app, context);
  add_evaluate_command(app, context);
}

}  // namespace

int main(int argc, char** argv) { return roomgen::cli::run_program(argc, argv, add_commands); }
