#include "roomgen/lab/compose.h"

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "add_commands.h"
#include "authors.h"
#include "designers.h"
#include "libraries.h"
#include "options.h"
#include "print.h"
#include "program_files.h"
#include "room_files.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"
#include "summary.h"
#include "tool_commands.h"

namespace roomgen::cli {

using namespace lab;

namespace {

namespace fs = std::filesystem;

struct ComposeCommand {
  ComposeRequest request;
  std::string output, size, room;
  std::vector<std::string> measures = std::vector<std::string>(complexity_measures().size());
  double seconds = 0.0;
  int pixels = 1024;
  bool force = false, strict = false, no_pictures = false;
  ComposeOptions options;
  LibraryOptions libraries;
  DesignerOptions designer;
};

void print_summary(const Context& context, const fs::path& folder, const Composition& composition,
                   const std::string& author, double seconds) {
  const ComposeRound& chosen = composition.chosen();
  if (context.json) {
    Json json = optimisation_json(chosen.result);
    json.erase("curve");
    json["output"] = folder.string();
    json["objects"] = chosen.result.scene.objects.size();
    json["report"] = to_json(chosen.report);
    json["rounds"] = composition.rounds.size();
    json["chosen"] = composition.best + 1;
    json["author"] = author;
    json["notes"] = chosen.written.notes;
    json["seconds"] = rounded(seconds, 3);
    std::fputs(dump_json(json).c_str(), stdout);
    return;
  }
  print_lines(chosen.written.notes);
  print_lines(composition.notes);
  std::printf("%s: %s (%zu rounds, %.1f s)\n", printable(folder.string()).c_str(),
              optimisation_headline(chosen.result).c_str(), composition.rounds.size(), seconds);
  print_lines(composed_lines(composition));
}

Status read_wishes(ComposeCommand& command) {
  for (std::size_t i = 0; i < command.measures.size(); ++i) {
    if (command.measures[i].empty()) continue;
    const auto& [name, range] = complexity_measures()[i];
    auto read = range_from(command.measures[i], std::string("--") + name, most_of_measure(name));
    if (!read) return read.error();
    command.request.complexity.*range = *read;
  }
  if (!command.size.empty()) {
    auto size = parse_size(command.size);
    if (!size) return size.error();
    command.request.plan.size = *size;
  }
  if (command.room.empty()) return {};
  auto room = read_room_file(command.room);
  if (!room) return room.error();
  command.request.plan.room = *std::move(room);
  return {};
}

Result<int> run(const Context& context, ComposeCommand& command) {
  const auto start = std::chrono::steady_clock::now();
  if (auto status = read_wishes(command); !status) return status.error();
  const fs::path folder = command.output.empty() ? fs::path("out") / folder_name(command.request.plan.prompt)
                                                 : fs::path(command.output);
  auto output = open_room_folder(folder, command.force);
  if (!output) return output.error();
  auto composed = compose_model(command.designer, context, cache_folder(command.libraries).string());
  if (!composed) return composed.error();
  auto library = open_all_libraries(command.libraries, context);
  if (!library) return library.error();
  const KindTable& kinds = KindTable::built_in();
  if (const auto reader = compose_reader(command.designer, composed->model.get(), composed->limited,
                                         composed->prompts))
    if (auto read = reader->read(command.request.plan); !read) return read.error();
  const CancelToken cancel = command.seconds > 0 ? context.cancel.within(std::chrono::duration<double>(command.seconds))
                                                 : context.cancel;
  command.options.optimise.cancel = command.request.plan.cancel = cancel;
  command.options.optimise.seed = command.request.plan.seed;
  Authors authors(*composed, command.designer, **library);
  const ProgramAuthor author = authors.author();
  authors.show(command.options);
  const bool shown = !context.quiet && ::isatty(STDERR_FILENO);
  int rounds = 0;
  if (!context.quiet)
    command.options.on_round = [&](const ComposeRound& round) {
      if (shown && command.options.rounds > 1)
        std::fprintf(stderr, "round %d: %s\n", ++rounds, optimisation_headline(round.result).c_str());
    };
  auto composition = compose_room(command.request, author, **library, kinds, command.options);
  if (!composition) return composition.error();
  if (context.cancel.cancelled() && holds_whole_scene(folder / "scene.json")) return older_stays(folder);
  const int pixels = command.no_pictures ? 0 : command.pixels;
  if (auto status = write_composed_room(*output, *composition, author.name, pixels); !status) return status.error();
  if (auto status = output->commit(); !status) return status.error();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  print_summary(context, folder, *composition, author.name, elapsed.count());
  if (context.cancel.cancelled()) return exit_interrupted;
  return command.strict && !composition->chosen().report.is_met() ? exit_failure : exit_ok;
}

}  // namespace

void add_compose_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<ComposeCommand>();
  auto* sub = add_tool_command(app, "compose");
  sub->add_option("prompt", command->request.plan.prompt,
                  "What room: \"a reading room with twelve shelves and seating for ten\"")
      ->required();
  sub->add_option("-o,--output", command->output, "Folder to write (default: out/ and the prompt)");
  sub->add_option("--seed", command->request.plan.seed, "Of plan, room and search")
      ->check(CLI::Range(std::uint64_t{0}, max_seed))
      ->capture_default_str();
  sub->add_option("--size", command->size, "Of the room, as 4x5: metres");
  sub->add_option("--room", command->room, "Room to furnish (room.json)");
  const char* help[] = {"Things in all, as 20..25", "People who can sit, as 8..12", "Pieces with shelves, as 9..",
                        "Covered share of the floor, as 0.4..0.5"};
  for (std::size_t i = 0; i < command->measures.size(); ++i)
    sub->add_option(std::string("--") + complexity_measures()[i].name, command->measures[i], help[i]);
  sub->add_option("--rounds", command->options.rounds, "Programs at most: 1 is without revisions")
      ->check(CLI::Range(1, 20))->capture_default_str();
  sub->add_option("--steps", command->options.optimise.steps, "Moves tried in each chain of a round")
      ->check(CLI::Range(1, 100000000))->capture_default_str();
  sub->add_option("--chains", command->options.optimise.chains, "Restarts, of which the best counts")
      ->check(CLI::Range(1, 1000))->capture_default_str();
  sub->add_option("--seconds", command->seconds, "Stop after so long with the best room so far")
      ->check(CLI::PositiveNumber);
  sub->add_option("--assets", command->options.assets_each, "Meshes of each kind to choose from")
      ->check(CLI::Range(1, 50))->capture_default_str();
  sub->add_flag_callback("--no-clusters", [command] { command->options.optimise.cluster_moves = false; },
                         "Move things singly only, for comparisons");
  sub->add_flag("--force", command->force, "Write into a folder that holds other files");
  sub->add_flag("--strict", command->strict, "Exit with 1 if anything that is asked for is not met");
  sub->add_flag("--no-pictures", command->no_pictures, "Leave out the pictures");
  sub->add_option("--pixels", command->pixels, "Length of the pictures' longer side")->capture_default_str();
  add_chat_options(*sub, command->designer);
  add_reader_option(*sub, command->designer);
  add_thinking_option(*sub, command->designer);
  add_library_options(*sub, command->libraries);
  sub->callback([command, &context] { context.run = [command, &context] { return run(context, *command); }; });
}

}  // namespace roomgen::cli
