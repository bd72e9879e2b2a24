#pragma once

#include "command.h"

namespace roomgen::cli {

// One function a command, each in a file of its name.
/// Of constraint programs; everything else is checked by `roomgen check`.
void add_check_command(CLI::App& app, Context& context);
void add_compose_command(CLI::App& app, Context& context);
void add_optimise_command(CLI::App& app, Context& context);
void add_tour_command(CLI::App& app, Context& context);
void add_frames_command(CLI::App& app, Context& context);
void add_questions_command(CLI::App& app, Context& context);
void add_benchmark_command(CLI::App& app, Context& context);
void add_experiment_command(CLI::App& app, Context& context);
void add_evaluate_command(CLI::App& app, Context& context);

}  // namespace roomgen::cli
