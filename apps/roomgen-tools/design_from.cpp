#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "add_commands.h"
#include "print.h"
#include "roomgen/base/file.h"
#include "roomgen/design/designer.h"
#include "tool_commands.h"

namespace roomgen::cli {

namespace {

struct DesignCommand {
  std::string scene, output;
  LearnOptions learning;
};

Result<int> learn(const Context& context, const DesignCommand& command) {
  const auto scene = read_scene(command.scene);
  if (!scene) return scene.error();
  const auto design = learn_design(*scene, command.learning);
  if (!design) return with_context(design.error(), command.scene);
  if (design->contains("remarks")) warn((*design)["remarks"].get<std::string>());
  const std::string text = dump_json(*design);
  if (command.output.empty()) {
    std::fputs(text.c_str(), stdout);
    return exit_ok;
  }
  if (auto written = write_file(command.output, text); !written) return written.error();
  if (!context.quiet) {
    const auto what = check_design(*design, command.output);
    std::printf("%s: %s\n", printable(command.output).c_str(), what ? what->c_str() : "design");
  }
  return exit_ok;
}

}  // namespace

void add_design_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<DesignCommand>();
  auto* group = add_tool_command(app, "design");
  group->require_subcommand(1);
  auto* sub = group->add_subcommand("from", "The design of a finished room");
  sub->add_option("scene", command->scene, "The room: scene.json")
      ->required()
      ->check(CLI::ExistingFile);
  sub->add_option("-o,--output", command->output, "File to write, else the output");
  sub->add_option("--name", command->learning.name,
                  "What the design is called (default: the room's wish)");
  sub->add_option("--for", command->learning.rooms,
                  "Kinds of rooms that it is a design of (default: the room's)");
  sub->add_flag("--keep-assets", command->learning.keep_assets,
                "Keep the models of libraries, not only what was built for the room");
  sub->callback([command, &context] {
    context.run = [command, &context] { return learn(context, *command); };
  });
}

}  // namespace roomgen::cli
