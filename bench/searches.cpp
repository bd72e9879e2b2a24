// What each of the three searches is worth: one by one, for a whole layout, and improvement, on the same
// rooms. Prints tables in Markdown.

#include <cstdio>

#include "room_cases.h"

namespace {

using namespace roomgen;

void print(const char* name, const bench::Outcome& outcome) {
  std::printf("| %s | %d of %d | %d of %d |", name, outcome.held, outcome.constraints,
              outcome.wanted - outcome.placed, outcome.wanted);
  if (outcome.requirements > 0) std::printf(" %d of %d |", outcome.met, outcome.requirements);
  std::printf(" %.1f | %.2f |\n", outcome.seconds, outcome.slowest);
}

void compare_on_problems(const bench::RoomCases& cases) {
  std::puts("| problems | constraints held | left out | s in all | s at most |\n|---|---|---|---|---|");
  SolveOptions options;
  const int rounds = options.rounds;
  options.layout_search = false, options.rounds = 0;
  print("one by one", cases.solve_all(options));
  options.rounds = rounds;
  print("one by one, improved", cases.solve_all(options));
  options.layout_search = true, options.rounds = 0;
  print("layout search, else one by one", cases.solve_all(options));
  options.rounds = rounds;
  print("all three", cases.solve_all(options));
}

void compare_on_plans(const bench::RoomCases& cases) {
  std::puts("| plans | constraints held | left out | requirements met | s in all | s at most |\n"
            "|---|---|---|---|---|---|");
  BuildOptions options;
  options.repair = false, options.improvement = Improvement::off;
  print("one by one", cases.furnish_all(options));
  options.repair = true;
  print("with repairs", cases.furnish_all(options));
  options.repair = false, options.improvement = Improvement::minimal;
  print("improved in the end", cases.furnish_all(options));
  options.repair = true;
  print("both", cases.furnish_all(options));
}

}  // namespace

int main() {
  const bench::RoomCases cases;
  compare_on_problems(cases);
  std::puts("");
  compare_on_plans(cases);
}
