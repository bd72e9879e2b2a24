// Random rooms with slanted walls, random things, constraints that need not make sense together: whatever
// cannot be placed is left out, and what is placed is right by two judges that share nothing.
#include "support/brute_force.h"
#include "support/random_problem.h"
#include "support/solved.h"

using namespace roomgen;

TEST_CASE("Nothing invalid is ever placed") {
  std::size_t placed = 0, wanted = 0;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    const auto problem = rooms::random_problem(seed);
    const auto solution = solved(problem, seed, 2);
    INFO("random problem " << seed);
    CHECK(violations(solution.scene) == std::vector<std::string>{});
    CHECK(brute_force::faults(solution.scene) == std::vector<std::string>{});
    REQUIRE(solution.scene.objects.size() + solution.scene.unplaced.size() == problem.tasks.size());
    placed += solution.scene.objects.size();
    wanted += problem.tasks.size();
  }
  // Left out only where a room is small or odd.
  CHECK(static_cast<double>(placed) > 0.85 * static_cast<double>(wanted));
}

TEST_CASE("Whatever the number of objects, each is placed or has a reason") {
  for (std::uint64_t seed = 500; seed < 504; ++seed) {
    const auto problem = rooms::random_problem(seed, 25);
    const auto scene = solved(problem, seed, 1).scene;
    for (const auto& task : problem.tasks) {
      int times = find_object(scene, task.object.id) ? 1 : 0;
      for (const auto& missing : scene.unplaced) {
        if (missing.id != task.object.id) continue;
        ++times;
        CHECK_FALSE(missing.reason.empty());
      }
      INFO(task.object.id);
      CHECK(times == 1);
    }
  }
}
