// Times the drawing of layouts: how many valid, distinct ones a second, and how far they are apart beside what searches
// from nothing and the solver's seeds find. Prints a table in Markdown. Every layout is examined as `check` does.
//
//   bench_samples [--count N] [--threads N] [--chains N] [problem.json or scene.json …]
//
// The meshes of a scene are those of the scene.glb beside it.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "roomgen/evaluate/report.h"
#include "roomgen/import/import.h"
#include "roomgen/solve/solve.h"

namespace {

using namespace roomgen;
namespace fs = std::filesystem;
using Layouts = std::vector<std::vector<Object>>;

constexpr std::size_t most_compared = 100;
constexpr int seeds = 24;
// Chains start from searches of their own: with so few layouts each is hardly a walk away from its start.
constexpr std::size_t starts_a_run = 8;

struct Case {
  std::string name;
  std::optional<Problem> problem;
  Scene scene;
  ModelTable models;
};

std::optional<Case> read_case(const fs::path& file) {
  Case one{file.parent_path().filename().string() + "/" + file.stem().string(), {}, {}, {}};
  if (auto problem = read_problem(file)) {
    one.problem = *std::move(problem);
    return one;
  }
  auto scene = read_scene(file);
  if (!scene) return std::fprintf(stderr, "%s\n", scene.error().message.c_str()), std::nullopt;
  one.scene = *std::move(scene);
  if (auto models = read_glb_models(file.parent_path() / "scene.glb", {})) one.models = *std::move(models);
  return one;
}

Samples draw(const Case& one, const SampleOptions& options) {
  const KindTable& kinds = KindTable::built_in();
  auto samples = one.problem ? sample(*one.problem, one.models, kinds, options)
                             : sample(one.scene, one.models, kinds, options);
  if (!samples) std::fprintf(stderr, "%s\n", samples.error().message.c_str()), std::exit(1);
  return *std::move(samples);
}

Layouts layouts_of(const Samples& samples, std::size_t first = 0) {
  Layouts layouts;
  for (std::size_t i = first; i < samples.layouts.size(); ++i)
    layouts.push_back(with_layout(samples.scene, samples.layouts[i]).objects);
  return layouts;
}

// The mean distance of a thing of the floor between two layouts, over all pairs of at most a hundred of them.
double spread(const Layouts& layouts) {
  double sum = 0.0;
  std::size_t count = 0;
  const std::size_t step = std::max<std::size_t>(1, layouts.size() / most_compared);
  for (std::size_t a = 0; a < layouts.size(); a += step)
    for (std::size_t b = 0; b < a; b += step)
      for (std::size_t i = 0; i < layouts[a].size(); ++i) {
        if (layouts[a][i].mount != Mount::floor) continue;
        sum += (layouts[a][i].position - layouts[b][i].position).norm();
        ++count;
      }
  return count ? sum / static_cast<double>(count) : 0.0;
}

double spread_of_solutions(const Case& one) {
  if (!one.problem) return 0.0;
  Layouts layouts;
  for (int seed = 0; seed < seeds; ++seed) {
    SolveOptions options;
    options.seed = static_cast<std::uint64_t>(seed);
    auto solution = solve(*one.problem, one.models, KindTable::built_in(), options);
    if (solution && (layouts.empty() || layouts.front().size() == solution->scene.objects.size()))
      layouts.push_back(std::move(solution->scene.objects));
  }
  return spread(layouts);
}

double spread_of_searches(const Case& one) {
  Layouts layouts;
  SampleOptions options;
  options.count = options.chains = starts_a_run;
  for (options.solve.seed = 0; options.solve.seed < seeds / starts_a_run; ++options.solve.seed)
    for (auto& layout : layouts_of(draw(one, options), 1))
      if (layouts.empty() || layouts.front().size() == layout.size()) layouts.push_back(std::move(layout));
  return spread(layouts);
}

std::size_t faults_of(const Case& one, const Samples& samples) {
  std::size_t faults = 0;
  for (const auto& layout : samples.layouts)
    faults += examine(with_layout(samples.scene, layout), one.models, KindTable::built_in()).violations.size();
  return faults;
}

void measure(const Case& one, const SampleOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t busy_before = std::clock();
  const Samples samples = draw(one, options);
  const double busy = static_cast<double>(std::clock() - busy_before) / CLOCKS_PER_SEC;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  int least = samples.constraints;
  for (const auto& layout : samples.layouts) least = std::min(least, layout.held);
  const double found = static_cast<double>(samples.layouts.size());
  const double distinct = 100.0 * found / static_cast<double>(std::max<std::size_t>(1, samples.drawn));
  std::printf("| %s | %zu | %zu | %.2f | %.0f | %.1f | %.1f %% | %d / %d | %zu | %.2f | %.2f | %.2f |\n",
              one.name.c_str(), samples.scene.objects.size(), samples.layouts.size(), elapsed.count(), found / elapsed.count(),
              1e3 * busy / std::max(1.0, found), distinct, least, samples.constraints, faults_of(one, samples),
              spread(layouts_of(samples)), spread_of_searches(one), spread_of_solutions(one));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  SampleOptions options;
  options.count = 1000;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const auto number = [&] { return i + 1 < argc ? std::strtoull(argv[++i], nullptr, 10) : 0; };
    if (argument == "--count") options.count = number();
    else if (argument == "--threads") options.threads = static_cast<unsigned>(number());
    else if (argument == "--chains") options.chains = number();
    else files.push_back(argument);
  }
  if (files.empty())
    for (const char* name : {"solver-scenes/balcony", "rooms/36-bathroom-rectangle", "solver-scenes/bedroom",
                             "solver-scenes/dining_room", "solver-scenes/l_shaped", "solver-scenes/living_room",
                             "rooms/01-bedroom-rectangle", "rooms/14-living-room-slanted",
                             "rooms/16-living-room-rectangle", "rooms/54-open-office-rectangle"})
      files.push_back(std::string(ROOMGEN_TEST_DATA) + "/" + name + ".json");
  std::printf("| room | objects | layouts | s | a second | ms of one core each | distinct | held at least | faults | "
              "apart m | of searches m | of solve() m |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const auto& file : files)
    if (const auto one = read_case(file)) measure(*one, options);
}
