#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "add_commands.h"
#include "any_plan.h"
#include "options.h"
#include "plan_text.h"
#include "print.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/design/designer.h"

namespace roomgen::cli {

namespace {

struct PlanOptions {
  PlanWish wish;
  std::string output;
  bool explain = false;
};

Result<int> run_plan(const PlanOptions& options, const Context& context) {
  const auto designer = make_rule_designer();
  const auto plan = make_plan(options.wish, *designer, context.cancel);
  if (!plan) return plan.error();
  const std::string json = dump_json(plan_json(*plan));
  if (!options.output.empty()) {
    if (auto written = write_file(options.output, json); !written) return written.error();
  }
  if (context.json) std::fputs(json.c_str(), stdout);
  else if (options.explain) print_lines(heard_lines(*plan));
  else if (options.output.empty() || !context.quiet) print_lines(plan_lines(*plan));
  return exit_ok;
}

}  // namespace

void add_plan_command(CLI::App& app, Context& context) {
  const auto options = std::make_shared<PlanOptions>();
  auto* command = app.add_subcommand("plan", "Say what a room, or each room of a dwelling, shall hold, without furnishing it");
  command->add_option("prompt", options->wish.prompt, "What the room shall be, in English")->required();
  command->add_option("--seed", options->wish.seed, "Another number, another room")
      ->capture_default_str();
  command->add_option("--size", options->wish.size, "Width and depth in metres, as in 4x5")
      ->check([](const std::string& text) {
        const auto size = parse_size(text);
        return size ? std::string() : size.error().message;
      });
  command->add_option("--room", options->wish.floor_plan, "A floor plan of your own: room.json, SVG or DXF");
  command->add_option("-o,--output", options->output, "Write the plan here (plan.json)");
  command->add_flag("--explain", options->explain,
                    "Say what each word of the prompt was taken for, and what is checked by it");
  command->callback([options, &context] {
    context.run = [options, &context] { return run_plan(*options, context); };
  });
}

}  // namespace roomgen::cli
