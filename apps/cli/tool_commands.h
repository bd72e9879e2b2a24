#pragma once

#include <CLI/CLI.hpp>
#include <string_view>

namespace roomgen::cli {

/// The commands that work on with rooms, and those of the laboratory, are programs of their own, so that a room needs no
/// more built and loaded than it takes to make one. `roomgen` offers them all the same and hands over.
bool is_tool_command(std::string_view name);

/// The command with what it is for; the same text in the program that does it and in the one that hands over.
CLI::App* add_tool_command(CLI::App& app, std::string_view name);

/// For the help of the program that hands over.
void list_tool_commands(CLI::App& app);

/// Becomes the program that does the command, with the same arguments. Returns only when that fails, with the exit code,
/// after saying why.
int hand_over(std::string_view command, char** argv);

/// The same for `roomgen check` of a constraint program.
int hand_over_check(const std::string& file, bool json);

}  // namespace roomgen::cli
