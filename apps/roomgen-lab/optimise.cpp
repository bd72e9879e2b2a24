#include "roomgen/lab/optimise.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "add_commands.h"
#include "libraries.h"
#include "options.h"
#include "print.h"
#include "program_files.h"
#include "room_files.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/generate/generate.h"
#include "tool_commands.h"

namespace roomgen::cli {

using namespace lab;

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_explained = 40;  // constraints of which those that conflict are looked for

struct OptimiseCommand {
  std::string program, output, room;
  double seconds = 0.0;
  std::size_t assets = 3;
  int pixels = 1024;
  bool force = false, strict = false, no_pictures = false, no_clusters = false;
  bool seeded = false;
  OptimiseOptions options;
  LibraryOptions libraries;
};

void print_summary(const Context& context, const fs::path& folder, const Optimisation& result,
                   const std::vector<std::string>& notes, double seconds) {
  if (context.json) {
    Json json = optimisation_json(result);
    json.erase("curve");
    json["output"] = folder.string();
    json["objects"] = result.scene.objects.size();
    json["held"] = std::ranges::count_if(result.constraints, &ConstraintVerdict::held);
    json["notes"] = notes;
    json["seconds"] = rounded(seconds, 3);
    std::fputs(dump_json(json).c_str(), stdout);
    return;
  }
  print_lines(notes);
  std::printf("%s: %s (%lld moves, %.1f s)\n", printable(folder.string()).c_str(), optimisation_headline(result).c_str(),
              result.moves, seconds);
  for (const auto& line : unmet_lines(result)) std::printf("  %s\n", printable(line).c_str());
}

Result<Room> wanted_room(const OptimiseCommand& command, const ConstraintProgram& program,
                         std::vector<std::string>& notes) {
  if (command.room.empty()) return room_of(program, command.options.seed, notes);
  auto room = read_room_file(command.room);
  if (room && room->type.empty()) room->type = program.room.type;
  return room;
}

Result<int> run(const Context& context, OptimiseCommand& command) {
  const auto start = std::chrono::steady_clock::now();
  auto program = read_program(command.program);
  if (!program) return program.error();
  const KindTable& kinds = KindTable::built_in();
  if (!command.seeded) command.options.seed = program->seed;
  std::vector<std::string> notes;
  for (const auto& finding : check(*program, kinds))
    notes.push_back(command.program + ": " + finding.at + ": " + finding.message);
  auto room = wanted_room(command, *program, notes);
  if (!room) return room.error();
  const fs::path folder = command.output.empty() ? fs::path("out") / fs::path(command.program).stem() : fs::path(command.output);
  auto output = open_room_folder(folder, command.force);
  if (!output) return output.error();
  auto library = open_all_libraries(command.libraries, context);
  if (!library) return library.error();
  auto stock = load_stock(wishes_for(kinds_to_stock(*program, kinds, command.options.seed)), **library, kinds, command.assets);
  if (!stock) return stock.error();

  command.options.cancel = command.seconds > 0 ? context.cancel.within(std::chrono::duration<double>(command.seconds))
                                               : context.cancel;
  const bool shown = !context.quiet && ::isatty(STDERR_FILENO);
  if (shown)
    command.options.on_progress = [&](const OptimiseProgress& progress) {
      std::fprintf(stderr, "\r\033[K%d of %d steps: %d things, constraints missed by %.2f", progress.step,
                   command.options.steps, progress.things, progress.violation);
    };
  auto result = optimise(*program, *room, *stock, kinds, command.options);
  if (shown) std::fputs("\r\033[K", stderr);
  if (!result) return result.error();
  if (context.cancel.cancelled() && holds_whole_scene(folder / "scene.json")) return older_stays(folder);
  for (const auto& kind : stock->missing) notes.push_back("the libraries have no " + kind);
  if (result->violation > 1e-9 && result->constraints.size() <= most_explained && !command.options.cancel.cancelled())
    if (const auto names = conflict(*program, *room, *stock, kinds, command.options); names && !names->empty())
      notes.push_back((names->size() == 1 ? "cannot be had here, as far as short searches tell: "
                                          : "cannot be had together here, as far as short searches tell: ") +
                      join(*names, ", "));
  if (auto status = write_optimised_room(*output, *program, *result, stock->models, command.no_pictures ? 0 : command.pixels);
      !status)
    return status.error();
  if (auto status = output->commit(); !status) return status.error();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  print_summary(context, folder, *result, notes, elapsed.count());
  if (context.cancel.cancelled()) return exit_interrupted;
  return command.strict && result->violation > 0.0 ? exit_failure : exit_ok;
}

}  // namespace

void add_optimise_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<OptimiseCommand>();
  auto* sub = add_tool_command(app, "optimise");
  sub->add_option("program", command->program, "program.json (docs/programs.md)")->required();
  sub->add_option("-o,--output", command->output, "Folder to write (default: out/ and the program's name)");
  auto* seed = sub->add_option("--seed", command->options.seed, "Seed of room and search (default: the program's)")
                   ->check(CLI::Range(std::uint64_t{0}, max_seed));
  sub->add_option("--steps", command->options.steps, "Moves tried in each chain")
      ->check(CLI::Range(1, 100000000))->capture_default_str();
  sub->add_option("--chains", command->options.chains, "Restarts, of which the best counts")
      ->check(CLI::Range(1, 1000))->capture_default_str();
  sub->add_option("--seconds", command->seconds, "Stop after so long with the best room so far (default: when all steps are done)")
      ->check(CLI::PositiveNumber);
  sub->add_option("--room", command->room, "Room to furnish (room.json) instead of the program's");
  sub->add_option("--assets", command->assets, "Meshes of each kind to choose from")
      ->check(CLI::Range(1, 50))->capture_default_str();
  sub->add_flag("--no-clusters", command->no_clusters, "Move things singly only, for comparisons");
  sub->add_flag("--force", command->force, "Write into a folder that holds other files");
  sub->add_flag("--strict", command->strict, "Exit with 1 if a constraint does not hold");
  sub->add_flag("--no-pictures", command->no_pictures, "Leave out the pictures");
  sub->add_option("--pixels", command->pixels, "Length of the pictures' longer side")->capture_default_str();
  add_library_options(*sub, command->libraries);
  sub->callback([command, seed, &context] {
    command->seeded = seed->count() > 0;
    command->options.cluster_moves = !command->no_clusters;
    context.run = [command, &context] { return run(context, *command); };
  });
}

}  // namespace roomgen::cli
