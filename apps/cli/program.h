#pragma once

#include "command.h"

namespace roomgen::cli {

/// The whole of a program: parses the command line of the commands that `add_commands` offers, runs the one that
/// was asked for, and says what went wrong. Returns the exit code.
int run_program(int argc, char** argv, void (*add_commands)(CLI::App& app, Context& context));

}  // namespace roomgen::cli
