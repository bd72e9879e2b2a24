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
#if defined(ROOMGEN_HAS_ASSETS) && defined(ROOMGEN_HAS_RENDER)
#include "designers.h"
#include "libraries.h"
#define ROOMGEN_HAS_DESIGNERS
#endif

namespace roomgen::cli {

namespace {

struct PlanOptions {
  PlanWish wish;
  std::string output;
  bool explain = false;
#ifdef ROOMGEN_HAS_DESIGNERS
  DesignerOptions designer;
#endif
};

/// Who plans and who reads, null for rules.
struct Planners {
#ifdef ROOMGEN_HAS_DESIGNERS
  ComposedDesigner composed;
#else
  struct {
    std::unique_ptr<Designer> designer = make_rule_designer();
    std::unique_ptr<Reader> reader;
  } composed;
#endif
};

Result<Planners> planners_of([[maybe_unused]] const PlanOptions& options,
                             [[maybe_unused]] const Context& context) {
#ifdef ROOMGEN_HAS_DESIGNERS
  auto composed =
      compose_designer(options.designer, context, cache_folder(LibraryOptions()).string());
  if (!composed) return composed.error();
  return Planners{*std::move(composed)};
#else
  return Planners();
#endif
}

// What is read, without a plan.
Result<int> print_brief(const PlanOptions& options, Reader* reader, const Context& context) {
  auto request = request_of(options.wish, context.cancel);
  if (!request) return request.error();
  if (reader)
    if (auto read = reader->read(*request); !read) return read.error();
  const auto brief = brief_json(*request);
  if (!brief) return brief.error();
  std::fputs(dump_json(*brief).c_str(), stdout);
  return exit_ok;
}

Result<int> run_plan(const PlanOptions& options, const Context& context) {
  const auto planners = planners_of(options, context);
  if (!planners) return planners.error();
  Reader* reader = planners->composed.reader.get();
  if (options.explain && context.json) return print_brief(options, reader, context);
  const auto plan = make_plan(options.wish, *planners->composed.designer, context.cancel, reader);
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
                    "Say what each word of the prompt was taken for, and what is checked by it; "
                    "with --json as brief.json");
#ifdef ROOMGEN_HAS_DESIGNERS
  add_chat_options(*command, options->designer);
  add_reader_option(*command, options->designer);
#endif
  command->callback([options, &context] {
    context.run = [options, &context] { return run_plan(*options, context); };
  });
}

}  // namespace roomgen::cli
