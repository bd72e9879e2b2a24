#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "add_commands.h"
#include "options.h"
#include "roomgen/base/text.h"
#include "roomgen/base/file.h"
#include "roomgen/generate/generate.h"
#include "roomgen/solve/solve.h"
#include "samples.h"

namespace roomgen::cli {

namespace {

struct SolveCommand {
  std::string problem;
  std::string output;
  SolveOptions options;
  bool strict = false;
  std::size_t samples = 0;  ///< 0: one solution
  unsigned threads = 0;
  ModelOptions models;
};

void print_solution(const Context& context, const SolveCommand& command, const Solution& solution,
                   double seconds) {
  const Scene& scene = solution.scene;
  if (context.json) {
    Json json;
    json["output"] = command.output;
    json["objects"] = scene.objects.size();
    json["unplaced"] = scene.unplaced.size();
    json["constraints"] = solution.constraints;
    json["held"] = solution.held;
    json["rounds"] = solution.rounds;
    json["seconds"] = rounded(seconds);
    std::fputs(dump_json(json).c_str(), stdout);
    return;
  }
  std::printf("%s: %zu of %zu objects placed, %d of %d constraints held (%.1f ms)\n",
              printable(command.output).c_str(), scene.objects.size(),
              scene.objects.size() + scene.unplaced.size(), solution.held, solution.constraints,
              1e3 * seconds);
  for (const auto& missing : scene.unplaced) std::printf("  %s\n", printable(missing.reason).c_str());
}

Result<int> run_samples(const Context& context, const SolveCommand& command) {
  SampleWish wish{command.problem, command.output, {}, command.models, command.strict};
  wish.options.count = command.samples;
  wish.options.threads = command.threads;
  wish.options.solve = command.options;
  wish.options.solve.cancel = context.cancel;
  return write_samples(context, wish);
}

Result<int> run(const Context& context, SolveCommand& command) {
  if (command.samples > 0) return run_samples(context, command);
  if (command.output.empty()) command.output = "scene.json";
  auto problem = read_problem(command.problem);
  if (!problem) return problem.error();
  command.options.cancel = context.cancel;
  const auto start = std::chrono::steady_clock::now();
  auto solution = solve(*problem, ModelTable(), KindTable::built_in(), command.options);
  if (!solution) return solution.error();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  if (solution->scene.incomplete && holds_whole_scene(command.output))
    return older_stays(command.output);
  if (auto written = write_file(command.output, dump_json(to_json(solution->scene))); !written)
    return written.error();
  print_solution(context, command, *solution, elapsed.count());
  if (solution->scene.incomplete) return exit_interrupted;
  return command.strict && !solution->scene.unplaced.empty() ? exit_failure : exit_ok;
}

void add_sample_options(CLI::App& sub, SolveCommand& command) {
  constexpr std::size_t most_samples = 1000000;
  auto* samples = sub.add_option("--samples", command.samples, "Draw so many distinct layouts, one JSON object a line")
                      ->check(CLI::Range(std::size_t{1}, most_samples));
  sub.add_option("--threads", command.threads, "Threads that draw layouts; as many as the machine has unless said")
      ->check(CLI::Range(1u, 256u))
      ->needs(samples);
  add_model_options(sub, command.models);
}

}  // namespace

void add_solve_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<SolveCommand>();
  auto* sub = app.add_subcommand("solve", "Place the objects of a problem file, without a designer");
  sub->add_option(
         "problem", command->problem,
         "problem.json (docs/problem.schema.json), or with --samples scene.json or plan.json")
      ->required();
  sub->add_option("-o,--output", command->output,
                  "Scene file to write (scene.json unless said), or file of layouts (stdout unless said)");
  sub->add_option("--seed", command->options.seed, "Seed of the search")
      ->check(CLI::Range(std::uint64_t{0}, max_seed))
      ->capture_default_str();
  sub->add_option("--rounds", command->options.rounds, "Rounds of improvement at most")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  sub->add_option("--pitch", command->options.place.pitch, "Grid pitch in metres")
      ->capture_default_str();
  sub->add_flag("--strict", command->strict, "Exit with 1 if something found no place, or not all layouts were found");
  add_sample_options(*sub, *command);
  sub->callback([command, &context] {
    context.run = [command, &context] { return run(context, *command); };
  });
}

}  // namespace roomgen::cli
