#include "tool_commands.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "beside_program.h"
#include "print.h"

namespace roomgen::cli {

namespace {

constexpr const char* tools = "roomgen-tools";
constexpr const char* lab = "roomgen-lab";

struct ToolCommand {
  const char *program, *name, *what;
};

constexpr std::array tool_commands = {
    ToolCommand{
        tools, "edit",
        "Change a room: exit 0 done, 1 not possible, 2 not understood; in 1 and 2 nothing changes"},
    ToolCommand{tools, "undo", "Take back the last edits of a room"},
    ToolCommand{tools, "redo", "Do again what was taken back"},
    ToolCommand{tools, "history", "List the edits of a room; * is the current state"},
    ToolCommand{tools, "branch", "List the branches of a room's history, or go to one"},
    ToolCommand{tools, "diff", "Say what is different between two states of a room"},
    ToolCommand{
        tools, "import",
        "Take the poses of a scene.glb that another program has changed back into the room"},
    ToolCommand{tools, "design",
                "Make a design of a finished room, after which others are made (docs/designs.md)"},
    ToolCommand{tools, "repl",
                "Change a room line by line, at a prompt or over a pipe; the exit code is then "
                "that of the first line that failed"},
    ToolCommand{
        tools, "mcp",
        "Serve an agent: the Model Context Protocol on standard input and output (docs/agents.md)"},
    ToolCommand{
        lab, "compose",
        "Furnish a room for a sentence by a constraint program that is revised until it is met"},
    ToolCommand{lab, "optimise",
                "Furnish a room as a constraint program says, by simulated annealing"},
    ToolCommand{lab, "tour", "Walk a camera through a scene so that it sees every object"},
    ToolCommand{lab, "frames", "Draw the frames of a tour: pictures, layers, labels, a video"},
    ToolCommand{lab, "questions", "Ask what a tour's frames show, with the true answers"},
    ToolCommand{lab, "benchmark", "Sets of spatial questions, and how models answer them"},
    ToolCommand{lab, "experiment",
                "Make a suite of things in several variants and score them (docs/objects.md), or "
                "change rooms step by step"},
    ToolCommand{lab, "evaluate",
                "Score rooms against what their descriptions ask for (SceneEval's measures)"},
};

const ToolCommand* find(std::string_view name) {
  const auto* found = std::ranges::find(tool_commands, name, &ToolCommand::name);
  return found == tool_commands.end() ? nullptr : found;
}

int become(const char* program, const std::string& command, char* const* argv) {
  const auto file = find_beside_program(
      program, "it does roomgen " + command + " (scripts/roomgen builds it too)");
  std::string reason;
  if (file) {
    execv(file->c_str(), argv);
    reason = file->string() + " cannot be run: " + std::strerror(errno);
  } else {
    reason = file.error().message;
  }
  std::fprintf(stderr, "roomgen: %s\n", one_line(reason).c_str());
  return exit_failure;
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

int hand_over(std::string_view name, char** argv) {
  const ToolCommand* command = find(name);
  return become(command ? command->program : tools, std::string(name), argv);
}

int hand_over_check(const std::string& file, bool json) {
  std::string words[] = {"roomgen", "check", file, "--json"};
  char* argv[] = {words[0].data(), words[1].data(), words[2].data(),
                  json ? words[3].data() : nullptr, nullptr};
  return become(lab, "check of a constraint program", argv);
}

}  // namespace roomgen::cli
