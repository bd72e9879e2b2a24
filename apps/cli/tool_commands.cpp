#include "tool_commands.h"

#include <algorithm>
#include <array>
#include <string>

namespace roomgen::cli {

namespace {

struct ToolCommand {
  const char *name, *what;
};

constexpr std::array tool_commands = {
    ToolCommand{"edit", "Change a room: exit 0 done, 1 not possible, 2 not understood; in 1 and 2 nothing changes"},
    ToolCommand{"undo", "Take back the last edits of a room"},
    ToolCommand{"redo", "Do again what was taken back"},
    ToolCommand{"history", "List the edits of a room; * is the current state"},
    ToolCommand{"branch", "List the branches of a room's history, or go to one"},
    ToolCommand{"diff", "Say what is different between two states of a room"},
    ToolCommand{"import", "Take the poses of a scene.glb that another program has changed back into the room"},
    ToolCommand{"repl",
                "Change a room line by line, at a prompt or over a pipe; the exit code is then that of the first line "
                "that failed"},
    ToolCommand{"mcp", "Serve an agent: the Model Context Protocol on standard input and output (docs/agents.md)"},
    ToolCommand{"compose", "Furnish a room for a sentence by a constraint program that is revised until it is met"},
    ToolCommand{"optimise", "Furnish a room as a constraint program says, by simulated annealing"},
    ToolCommand{"tour", "Walk a camera through a scene so that it sees every object"},
    ToolCommand{"frames", "Draw the frames of a tour: pictures, layers, labels, a video"},
    ToolCommand{"questions", "Ask what a tour's frames show, with the true answers"},
    ToolCommand{"benchmark", "Sets of spatial questions, and how models answer them"},
    ToolCommand{"experiment",
                "Make a suite of things in several variants and score them (docs/objects.md), or change rooms step by "
                "step"},
};

const ToolCommand* find(std::string_view name) {
  const auto* found = std::ranges::find(tool_commands, name, &ToolCommand::name);
  return found == tool_commands.end() ? nullptr : found;
}

}  // namespace

bool is_tool_command(std::string_view name) { return find(name) != nullptr; }

CLI::App* add_tool_command(CLI::App& app, std::string_view name) {
  const ToolCommand* command = find(name);
  return app.add_subcommand(std::string(name), command ? command->what : "");
}

void list_tool_commands(CLI::App& app) {
  for (const auto& command : tool_commands) app.add_subcommand(command.name, command.what);
}

}  // namespace roomgen::cli
