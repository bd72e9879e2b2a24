#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "roomgen/base/json.h"
#include "support/random_problem.h"
#include "support/solved.h"

using namespace roomgen;

TEST_CASE("A solve that is cancelled beforehand places nothing and is marked incomplete") {
  const auto problem = rooms::random_problem(1);
  SolveOptions options;
  options.cancel.cancel();
  const auto solution = solve(problem, ModelTable(), KindTable::built_in(), options);
  REQUIRE(solution);
  CHECK(solution->scene.incomplete);
  CHECK(solution->scene.objects.empty());
  CHECK(solution->scene.unplaced.size() == problem.tasks.size());
  CHECK(to_json(solution->scene)["incomplete"] == true);
}

TEST_CASE("A solve that is cancelled midway returns what it has, all of it sound") {
  // More rounds than anybody waits for, on a room that can never be whole.
  Problem problem = rooms::random_problem(2);
  problem.tasks.push_back({rooms::thing("hall-0", "sofa", {50, 50, 1}), std::nullopt, std::nullopt});
  SolveOptions options;
  options.rounds = 1000000000;
  std::thread stopper([&, token = options.cancel]() mutable {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    token.cancel();
  });
  const auto solution = solve(problem, ModelTable(), KindTable::built_in(), options);
  stopper.join();
  REQUIRE(solution);
  CHECK(solution->scene.incomplete);
  CHECK(solution->scene.objects.size() + solution->scene.unplaced.size() == problem.tasks.size());
  CHECK(violations(solution->scene).empty());
}

TEST_CASE("A solve that nobody stops is complete") {
  CHECK_FALSE(solved(rooms::random_problem(3), 0, 2).scene.incomplete);
}
