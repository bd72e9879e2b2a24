#pragma once

#include <CLI/CLI.hpp>
#include <string_view>

namespace roomgen::cli {

/// The commands that work on with rooms are a program of their own, roomgen-tools, so that a room needs no more
/// built and loaded than it takes to make one. `roomgen` offers them all the same and hands over.
bool is_tool_command(std::string_view name);

/// The command with what it is for; the same text in both programs.
CLI::App* add_tool_command(CLI::App& app, std::string_view name);

/// For the help of the program that hands over.
void list_tool_commands(CLI::App& app);

}  // namespace roomgen::cli
