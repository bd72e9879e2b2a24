#include "room_cases.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "roomgen/assets/catalogue.h"
#include "roomgen/create/create.h"
#include "roomgen/design/designer.h"

namespace roomgen::bench {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t every_third = 3;
constexpr std::uint64_t seed = 1;

std::vector<Problem> read_problems(std::size_t step) {
  std::vector<fs::path> files;
  for (const char* folder : {"/solver-scenes", "/rooms"})
    for (const auto& entry : fs::directory_iterator(std::string(ROOMGEN_TEST_DATA) + folder))
      if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<Problem> problems;
  for (std::size_t i = 0; i < files.size(); i += step)
    if (auto problem = read_problem(files[i])) problems.push_back(*std::move(problem));
  return problems;
}

std::vector<std::string> read_prompts(std::size_t step) {
  std::vector<std::string> prompts;
  std::ifstream lines(ROOMGEN_BENCH_DATA "/golden/prompts.txt");
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line); ++number)
    if (number % (every_third * step) == 0) prompts.push_back(line);
  std::stringstream full;
  full << std::ifstream(ROOMGEN_BENCH_DATA "/rooms/full-living-room.txt").rdbuf();
  prompts.push_back(full.str());
  return prompts;
}

double seconds_since(std::clock_t start) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

void add_time(std::clock_t start, Outcome& outcome) {
  const double seconds = seconds_since(start);
  outcome.seconds += seconds;
  outcome.slowest = std::max(outcome.slowest, seconds);
}

}  // namespace

RoomCases::RoomCases(std::size_t step) : problems_(read_problems(step)) {
  auto catalogue = assets::open_catalogue({});
  if (!catalogue) {
    std::fprintf(stderr, "no furniture: %s\n", catalogue.error().message.c_str());
    return;
  }
  library_ = make_first_of({*std::move(catalogue), create::make_created_library()});
  warm_ = std::make_unique<WarmLibrary>(*library_);
  const auto designer = make_rule_designer();
  for (const auto& prompt : read_prompts(step)) {
    PlanRequest request;
    request.prompt = prompt;
    request.seed = seed;
    if (auto plan = designer->plan(request)) plans_.push_back(*std::move(plan));
  }
  furnish_all({});  // loads the meshes
}

RoomCases::~RoomCases() = default;

Outcome RoomCases::solve_all(const SolveOptions& options) const {
  Outcome outcome;
  for (const auto& problem : problems_) {
    const auto start = std::clock();
    auto solution = roomgen::solve(problem, ModelTable(), KindTable::built_in(), options);
    add_time(start, outcome);
    if (!solution) continue;
    ++outcome.rooms;
    outcome.constraints += solution->constraints;
    outcome.held += solution->held;
    outcome.wanted += static_cast<int>(problem.tasks.size());
    outcome.placed += static_cast<int>(solution->scene.objects.size());
    outcome.scenes.push_back(std::move(solution->scene));
  }
  return outcome;
}

Outcome RoomCases::furnish_all(const BuildOptions& options) const {
  Outcome outcome;
  BuildOptions seeded = options;
  seeded.seed = seed;
  for (const auto& plan : plans_) {
    const auto designer = make_rule_designer();
    const auto start = std::clock();
    auto room = generate(plan, *designer, *warm_, KindTable::built_in(), seeded);
    add_time(start, outcome);
    if (!room) continue;
    ++outcome.rooms;
    outcome.constraints += room->constraints;
    outcome.held += room->held;
    outcome.placed += static_cast<int>(room->scene.objects.size());
    outcome.wanted += static_cast<int>(room->scene.objects.size() + room->scene.unplaced.size());
    for (const auto& verdict : room->scene.requirements) {
      ++outcome.requirements;
      outcome.met += verdict.met() ? 1 : 0;
    }
    outcome.scenes.push_back(std::move(room->scene));
  }
  return outcome;
}

Outcome sum(Outcome a, const Outcome& b) {
  a.rooms += b.rooms;
  a.constraints += b.constraints, a.held += b.held;
  a.wanted += b.wanted, a.placed += b.placed;
  a.requirements += b.requirements, a.met += b.met;
  a.seconds += b.seconds;
  a.slowest = std::max(a.slowest, b.slowest);
  a.scenes.insert(a.scenes.end(), b.scenes.begin(), b.scenes.end());
  return a;
}

}  // namespace roomgen::bench
