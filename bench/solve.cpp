// Times the solver in-process: each problem with several seeds. Prints a table in Markdown. Milliseconds
// are processor time of the one thread that works, so that a busy machine does not change them much.
//
//   bench_solve [--seeds N] [FILE or FOLDER …]

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "roomgen/evaluate/report.h"
#include "roomgen/solve/solve.h"

namespace {

using namespace roomgen;
namespace fs = std::filesystem;

struct Row {
  std::string name;
  std::size_t objects = 0;
  std::vector<double> milliseconds;
  int rounds = 0, placed = 0, wanted = 0, held = 0, constraints = 0, faults = 0;
};

std::vector<fs::path> problem_files(const std::vector<std::string>& arguments) {
  std::vector<fs::path> files;
  for (const auto& argument : arguments) {
    if (!fs::is_directory(argument)) {
      files.push_back(argument);
      continue;
    }
    for (const auto& entry : fs::directory_iterator(argument))
      if (entry.path().extension() == ".json" &&
          entry.path().string().find(".witness.") == std::string::npos)
        files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

Row measure(const fs::path& file, int seeds) {
  Row row;
  row.name = file.stem().string();
  const auto problem = read_problem(file);
  if (!problem) {
    std::fprintf(stderr, "%s\n", problem.error().message.c_str());
    return row;
  }
  row.objects = problem->tasks.size();
  for (int seed = 0; seed < seeds; ++seed) {
    SolveOptions options;
    options.seed = static_cast<std::uint64_t>(seed);
    const std::clock_t start = std::clock();
    const auto solution = solve(*problem, ModelTable(), KindTable::built_in(), options);
    const double elapsed = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (!solution) continue;
    row.milliseconds.push_back(elapsed);
    row.rounds += solution->rounds;
    row.placed += static_cast<int>(solution->scene.objects.size());
    row.wanted += static_cast<int>(problem->tasks.size());
    row.held += solution->held;
    row.constraints += solution->constraints;
    row.faults += static_cast<int>(
        examine(solution->scene, ModelTable(), KindTable::built_in()).violations.size());
  }
  return row;
}

void print(const Row& row) {
  const auto worst = row.milliseconds.empty()
                         ? 0.0
                         : *std::max_element(row.milliseconds.begin(), row.milliseconds.end());
  const double rounds = static_cast<double>(row.rounds) /
                        static_cast<double>(std::max<std::size_t>(1, row.milliseconds.size()));
  std::printf("| %s | %zu | %.1f | %.1f | %.1f | %d / %d | %d / %d | %d |\n", row.name.c_str(),
              row.objects, median(row.milliseconds), worst, rounds, row.placed, row.wanted, row.held, row.constraints,
              row.faults);
}

}  // namespace

int main(int argc, char** argv) {
  int seeds = 5;
  std::vector<std::string> arguments;
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) == "--seeds" && i + 1 < argc) seeds = std::atoi(argv[++i]);
    else arguments.push_back(argv[i]);
  }
  if (arguments.empty()) arguments = {ROOMGEN_TEST_DATA "/solver-scenes"};

  std::printf("| room | objects | median ms | worst ms | rounds | placed | constraints held | faults |\n");
  std::printf("|---|---|---|---|---|---|---|---|\n");
  Row all;
  all.name = "all";
  for (const auto& file : problem_files(arguments)) {
    const Row row = measure(file, seeds);
    print(row);
    all.objects += row.objects;
    all.rounds += row.rounds;
    all.placed += row.placed, all.wanted += row.wanted;
    all.held += row.held, all.constraints += row.constraints, all.faults += row.faults;
    all.milliseconds.insert(all.milliseconds.end(), row.milliseconds.begin(),
                            row.milliseconds.end());
  }
  print(all);
}
