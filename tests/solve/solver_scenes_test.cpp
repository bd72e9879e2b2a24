#include <filesystem>

#include "support/brute_force.h"
#include "support/solved.h"

using namespace roomgen;

namespace {

Problem read(const char* name) {
  auto problem = read_problem(std::filesystem::path(ROOMGEN_TEST_DATA) / "solver-scenes" /
                              (std::string(name) + ".json"));
  REQUIRE(problem);
  return *std::move(problem);
}

constexpr const char* scenes[] = {"balcony", "bedroom", "dining_room", "l_shaped", "living_room"};

}  // namespace

TEST_CASE("The published solver scenes are furnished whole with every constraint held") {
  for (const char* name : scenes) {
    const auto problem = read(name);
    const auto solution = solved(problem);
    INFO(name);
    CHECK(solution.scene.objects.size() == problem.tasks.size());
    CHECK(solution.held == solution.constraints);
  }
}

TEST_CASE("For other seeds the solver scenes are whole too, valid, and lose a constraint now and then") {
  int constraints = 0, held = 0;
  for (const char* name : scenes) {
    const auto problem = read(name);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const auto solution = solved(problem, seed);
      INFO(name << ", seed " << seed);
      CHECK(solution.scene.objects.size() == problem.tasks.size());
      CHECK(solution.held >= solution.constraints - 1);
      CHECK(violations(solution.scene) == std::vector<std::string>{});
      CHECK(brute_force::faults(solution.scene) == std::vector<std::string>{});
      constraints += solution.constraints;
      held += solution.held;
    }
  }
  WARN(held << " of " << constraints << " constraints held");
  CHECK(held >= 0.99 * constraints);
}
