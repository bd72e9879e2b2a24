// How the solver's cost grows: with the number of objects at equal density, and with the free area at equal
// number. Prints tables in Markdown; milliseconds of processor time, the median of a few seeds.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

#include "roomgen/scene/synthetic.h"
#include "roomgen/solve/solve.h"

namespace {

using namespace roomgen;

struct Cost {
  double milliseconds = 0.0;
  double placed = 0.0;  ///< share
};

Cost measure(const SyntheticOptions& base, int rounds) {
  constexpr int seeds = 5;
  std::vector<double> times;
  double placed = 0.0;
  for (int seed = 0; seed < seeds; ++seed) {
    SyntheticOptions options = base;
    options.seed = static_cast<std::uint64_t>(seed);
    const Problem problem = synthetic_problem(options);
    SolveOptions solve_options;
    solve_options.rounds = rounds;
    const std::clock_t start = std::clock();
    const auto solution = solve(problem, ModelTable(), CategoryTable::built_in(), solve_options);
    times.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    if (solution)
      placed += static_cast<double>(solution->scene.objects.size()) / options.objects / seeds;
  }
  std::sort(times.begin(), times.end());
  return {times[times.size() / 2], placed};
}

void print_row(int objects, double area, const Cost& plain, const Cost& guided) {
  std::printf("| %d | %.0f | %.1f | %.3f | %.1f | %.3f | %.0f %% |\n", objects, area,
              plain.milliseconds, plain.milliseconds / objects, guided.milliseconds,
              guided.milliseconds / objects, 100.0 * plain.placed);
}

void print_case(int objects, double area) {
  SyntheticOptions options;
  options.objects = objects;
  options.area_per_object = area / objects;
  const Cost plain = measure(options, 0);
  options.suggestions = true;
  print_row(objects, area, plain, measure(options, 0));
}

}  // namespace

int main() {
  const char* header =
      "| objects | m2 | ms | ms an object | ms, with suggestions | ms an object | placed |\n"
      "|---|---|---|---|---|---|---|\n";
  std::printf("Objects at 3 m2 each, one pass:\n\n%s", header);
  for (int objects : {5, 10, 20, 40, 80, 120, 160, 200}) print_case(objects, 3.0 * objects);
  std::printf("\nTwenty objects, growing room, one pass:\n\n%s", header);
  for (double area : {60.0, 90.0, 120.0, 180.0, 240.0, 360.0}) print_case(20, area);
}
