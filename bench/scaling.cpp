// How the solver's cost grows: with the number of objects in one room, with the room for equal objects, and
// with both at equal density. Prints tables in Markdown; milliseconds of processor time, the median of a
// few seeds.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <utility>
#include <vector>

#include "roomgen/solve/solve.h"
#include "synthetic.h"

namespace {

using namespace roomgen;

struct Cost {
  double milliseconds = 0.0;
  double placed = 0.0;  ///< share
};

Cost measure(int objects, double area) {
  constexpr int seeds = 3;
  std::vector<double> times;
  double placed = 0.0;
  for (int seed = 0; seed < seeds; ++seed) {
    SyntheticOptions options;
    options.objects = objects;
    options.area_per_object = area / objects;
    options.seed = static_cast<std::uint64_t>(seed);
    const Problem problem = synthetic_problem(options);
    const std::clock_t start = std::clock();
    const auto solution = solve(problem, ModelTable(), KindTable::built_in());
    times.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    if (solution)
      placed += static_cast<double>(solution->scene.objects.size()) / options.objects / seeds;
  }
  std::sort(times.begin(), times.end());
  return {times[times.size() / 2], placed};
}

void print_table(const char* title, const std::vector<std::pair<int, double>>& cases) {
  std::printf("\n%s:\n\n| objects | m2 | ms | ms an object | placed |\n|---|---|---|---|---|\n", title);
  for (const auto& [objects, area] : cases) {
    const Cost cost = measure(objects, area);
    std::printf("| %d | %.0f | %.1f | %.2f | %.0f %% |\n", objects, area, cost.milliseconds,
                cost.milliseconds / objects, 100.0 * cost.placed);
  }
}

}  // namespace

int main() {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  std::vector<std::pair<int, double>> crowd, room, both;
  for (int objects : {5, 10, 20, 40, 80, 120, 160, 200}) {
    crowd.emplace_back(objects, 600.0);
    both.emplace_back(objects, 3.0 * objects);
  }
  for (double area : {60.0, 90.0, 120.0, 180.0, 240.0, 360.0, 600.0}) room.emplace_back(20, area);
  print_table("More and more objects in one room", crowd);
  print_table("Twenty objects in a growing room", room);
  print_table("Objects at 3 m2 each", both);
}
