// How fast and how well constraint programs are optimised, on one core.
//   bench_programs PROGRAM.json... [--steps N] [--no-clusters]   moves a second, and what became of the room
//   bench_programs --compare PROGRAM.json...                     with and without moves of clusters, over steps
//   bench_programs --scale                                       moves a second over the number of things
// Boxes of the kinds' usual sizes stand for meshes, so that no library is needed. Seconds are of the processor.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include "roomgen/lab/optimise.h"

namespace {

using namespace roomgen;
using namespace roomgen::lab;

class Stopwatch {
 public:
  double seconds() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t start_ = std::clock();
};

Stock boxes(const ConstraintProgram& program, const KindTable& kinds) {
  Stock stock;
  for (const auto& name : kinds_to_stock(program, kinds)) {
    const Kind& kind = kinds.get(name);
    for (const double factor : {1.0, 0.9, 1.08}) {
      Object object;
      object.category = name;
      object.traits = kind.traits;
      object.size = {kind.size.x() * factor, kind.size.y() * factor, kind.size.z()};
      object.mount = kind.mount;
      stock.articles[name].push_back(object);
    }
  }
  return stock;
}

void measure(const std::string& path, OptimiseOptions options) {
  const KindTable& kinds = KindTable::built_in();
  const auto program = read_program(path);
  if (!program) return static_cast<void>(std::fprintf(stderr, "%s\n", program.error().message.c_str()));
  std::vector<std::string> notes;
  const auto room = room_of(*program, options.seed, notes);
  if (!room) return static_cast<void>(std::fprintf(stderr, "%s\n", room.error().message.c_str()));
  const Stock stock = boxes(*program, kinds);
  options.chains = 1;
  const Stopwatch watch;
  const auto result = optimise(*program, *room, stock, kinds, options);
  const double seconds = watch.seconds();
  if (!result) return static_cast<void>(std::fprintf(stderr, "%s\n", result.error().message.c_str()));
  std::printf("%-44s %4zu things  %9.0f moves/s  missed %.3f  loss %9.3f  covered %.3f\n", path.c_str(),
              result->scene.objects.size(), static_cast<double>(result->moves) / seconds, result->violation,
              result->loss, result->occupancy);
  for (std::size_t i = 0; i < result->tried_by_kind.size(); ++i)
    std::printf("  %-18s %8lld tried %8lld taken\n", optimise_move_names()[i].c_str(), result->tried_by_kind[i],
                result->accepted_by_kind[i]);
}

/// The means over seeds of what rooms miss and of their loss, and how many miss nothing.
struct Quality {
  double violation = 0.0, loss = 0.0;
  int met = 0, runs = 0;
};

Quality quality(const ConstraintProgram& program, const OptimiseOptions& base, int seeds) {
  const KindTable& kinds = KindTable::built_in();
  const Stock stock = boxes(program, kinds);
  Quality sum;
  for (int seed = 1; seed <= seeds; ++seed) {
    OptimiseOptions options = base;
    options.seed = static_cast<std::uint64_t>(seed);
    std::vector<std::string> notes;
    const auto room = room_of(program, options.seed, notes);
    const auto result = room ? optimise(program, *room, stock, kinds, options) : Result<Optimisation>(room.error());
    if (!result) continue;
    sum.violation += result->violation, sum.loss += result->loss, sum.met += result->violation < 1e-9, ++sum.runs;
  }
  return sum;
}

void compare(const std::vector<std::string>& paths) {
  constexpr int seeds = 6;
  std::puts("| program | steps | clusters too: met | missed | loss | singly: met | missed | loss |\n|---|---|---|---|---|---|---|---|");
  for (const auto& path : paths) {
    const auto program = read_program(path);
    if (!program) continue;
    for (const int steps : {5000, 20000, 60000}) {
      OptimiseOptions options;
      options.chains = 1, options.steps = steps;
      const Quality with = quality(*program, options, seeds);
      options.cluster_moves = false;
      const Quality without = quality(*program, options, seeds);
      const auto slash = path.rfind('/');
      std::printf("| %s | %d | %d of %d | %.2f | %.2f | %d of %d | %.2f | %.2f |\n",
                  path.substr(slash == std::string::npos ? 0 : slash + 1).c_str(), steps, with.met, with.runs,
                  with.violation / seeds, with.loss / seeds, without.met, without.runs, without.violation / seeds,
                  without.loss / seeds);
      std::fflush(stdout);
    }
  }
}

/// Tables with four chairs each, spread out, in a room that grows with them.
ConstraintProgram tables_program(int tables) {
  using namespace programs;
  ConstraintProgram program;
  program.source = "tables";
  program.room.type = "restaurant";
  const double side = std::sqrt(9.0 * tables);
  program.room.width = program.room.depth = Range{side, side};
  program.sets = {{"table", with(of_kind("dining_table"), "on_floor", room())},
                  {"chair", with(of_kind("dining_chair"), "on_floor", room())}};
  const ProgramTerm seats =
      within(count(with(set("chair"), "front_against", variable("t"))), 4.0, 4.0);
  program.constraints = {{"tables", within(count(set("table")), tables, tables)},
                         {"seats", for_all("t", set("table"), seats)}};
  program.scores = {{"apart", mean("t", set("table"), maximize(1.0, distance(variable("t"), set("table"))))},
                    {"square", minimize(1.0, term(ProgramOp::angle, {set("table"), room()}))}};
  return program;
}

void scale() {
  std::puts("| things | moves a second | missed |\n|---|---|---|");
  for (const int tables : {2, 4, 10, 20, 40}) {
    const ConstraintProgram program = tables_program(tables);
    const KindTable& kinds = KindTable::built_in();
    std::vector<std::string> notes;
    const auto room = room_of(program, 1, notes);
    if (!room) return static_cast<void>(std::fprintf(stderr, "%s\n", room.error().message.c_str()));
    OptimiseOptions options;
    options.chains = 1, options.steps = 60000;
    const Stopwatch watch;
    const auto result = optimise(program, *room, boxes(program, kinds), kinds, options);
    const double seconds = watch.seconds();
    if (!result) return static_cast<void>(std::fprintf(stderr, "%s\n", result.error().message.c_str()));
    std::printf("| %zu | %.0f | %.2f |\n", result->scene.objects.size(), static_cast<double>(result->moves) / seconds,
                result->violation);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int count, char** arguments) {
  OptimiseOptions options;
  options.seed = 1;
  options.steps = 100000;
  std::vector<std::string> paths;
  bool comparing = false;
  for (int i = 1; i < count; ++i) {
    if (!std::strcmp(arguments[i], "--steps") && i + 1 < count) options.steps = std::atoi(arguments[++i]);
    else if (!std::strcmp(arguments[i], "--no-clusters")) options.cluster_moves = false;
    else if (!std::strcmp(arguments[i], "--scale")) return scale(), 0;
    else if (!std::strcmp(arguments[i], "--compare")) comparing = true;
    else paths.push_back(arguments[i]);
  }
  if (comparing) return compare(paths), 0;
  for (const auto& path : paths) measure(path, options);
}
