// What half and twice of each weight of the score (Weights) changes. Prints a table in Markdown: for each,
// how many rooms come out otherwise and how much more or less they hold.
//
//   bench_weights [STEP [NAME...]]   each STEP-th of the rooms (2), these weights (all)

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "room_cases.h"

namespace {

using namespace roomgen;

const std::vector<std::pair<const char*, double Weights::*>>& all_weights() {
  static const std::vector<std::pair<const char*, double Weights::*>> all = {
      {"relations", &Weights::relations},
      {"rest", &Weights::rest},
      {"walkway", &Weights::walkway},
      {"spread", &Weights::spread},
      {"evenness", &Weights::evenness},
      {"closeness", &Weights::closeness},
      {"facing", &Weights::facing},
      {"off", &Weights::off},
      {"metres_a_radian", &Weights::metres_a_radian},
      {"first_habit", &Weights::first_habit},
      {"habit_step", &Weights::habit_step},
      {"most_steps", &Weights::most_steps},
      {"burden", &Weights::burden},
      {"most_preference", &Weights::most_preference},
      {"reserve_open", &Weights::reserve_open},
      {"reserve_taken", &Weights::reserve_taken},
      {"crowded", &Weights::crowded},
      {"squareness", &Weights::squareness},
      {"pair_gap", &Weights::pair_gap},
      {"asked_pair_gap", &Weights::asked_pair_gap},
      {"asked_middle", &Weights::asked_middle},
      {"askew", &Weights::askew},
      {"beyond_opposite", &Weights::beyond_opposite},
      {"seat_place", &Weights::seat_place},
      {"over_place", &Weights::over_place},
      {"plan_location", &Weights::plan_location},
  };
  return all;
}

bool stands_as_in(const Scene& other, const Object& object) {
  for (const auto& one : other.objects)
    if (one.id == object.id) return one.position == object.position && one.yaw == object.yaw;
  return false;
}

struct Change {
  int rooms = 0, things = 0;
};

Change change(const bench::Outcome& before, const bench::Outcome& after) {
  Change result;
  for (std::size_t i = 0; i < before.scenes.size() && i < after.scenes.size(); ++i) {
    int things = 0;
    for (const auto& object : after.scenes[i].objects)
      things += stands_as_in(before.scenes[i], object) ? 0 : 1;
    result.things += things;
    result.rooms += things > 0 ? 1 : 0;
  }
  return result;
}

bench::Outcome make_all(const bench::RoomCases& cases, const Weights& weights) {
  SolveOptions solving;
  solving.place.weights = weights;
  BuildOptions building;
  building.place.weights = weights;
  return bench::sum(cases.solve_all(solving), cases.furnish_all(building));
}

void print(const char* name, double factor, const bench::Outcome& before, const bench::Outcome& after) {
  const Change changed = change(before, after);
  std::printf("| %s | x %g | %d of %d | %d | %+d | %+d | %+d |\n", name, factor, changed.rooms, after.rooms,
              changed.things, after.held - before.held, after.placed - before.placed,
              after.met - before.met);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t step = argc > 1 ? static_cast<std::size_t>(std::max(1, std::atoi(argv[1]))) : 2;
  const std::set<std::string> wanted(argv + std::min(argc, 2), argv + argc);
  const bench::RoomCases cases(step);
  const bench::Outcome before = make_all(cases, {});
  std::printf("%d rooms: %d of %d constraints held, %d of %d things placed, %d of %d requirements met\n\n",
              before.rooms, before.held, before.constraints, before.placed, before.wanted, before.met,
              before.requirements);
  std::puts("| weight | times | rooms changed | things moved | constraints held | placed | requirements met |\n"
            "|---|---|---|---|---|---|---|");
  for (const auto& [name, member] : all_weights()) {
    if (!wanted.empty() && !wanted.contains(name)) continue;
    for (double factor : {0.5, 2.0}) {
      Weights weights;
      weights.*member *= factor;
      print(name, factor, before, make_all(cases, weights));
    }
  }
}
