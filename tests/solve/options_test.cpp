#include "support/random_problem.h"
#include "support/solved.h"

using namespace roomgen;

TEST_CASE("Options out of range are refused with the range") {
  const auto complaint = [](auto change) {
    SolveOptions options;
    change(options);
    const auto solution = solve(rooms::random_problem(1), ModelTable(), KindTable::built_in(), options);
    return solution ? "" : solution.error().message;
  };
  CHECK(complaint([](SolveOptions& o) { o.place.pitch = 0; }).find("pitch") != std::string::npos);
  CHECK(complaint([](SolveOptions& o) { o.place.pitch = -1; }).find("pitch") != std::string::npos);
  CHECK(complaint([](SolveOptions& o) { o.place.pitch = std::nan(""); }).find("pitch") !=
        std::string::npos);
  CHECK(complaint([](SolveOptions& o) { o.place.fusion.alpha = 1.1; }).find("alpha") !=
        std::string::npos);
  CHECK(complaint([](SolveOptions& o) { o.place.fusion.c = 0; }).find("constant") !=
        std::string::npos);
}

TEST_CASE("All weight on the constraints forgets the suggestion, all on the suggestion follows it") {
  //  Suggested in the middle, wanted at the edge.
  Problem problem;
  problem.room = rooms::box(4, 4);
  problem.tasks = {{rooms::thing("plant-0", "plant", {0.4, 0.4, 0.9}), Vec2(2, 2), std::nullopt}};
  problem.tasks[0].object.relations = {{RelationKind::edge, ""}};
  const auto distance = [&](double alpha) {
    SolveOptions options;
    options.place.fusion.alpha = alpha;
    options.rounds = 0;
    const auto solution = solve(problem, ModelTable(), KindTable::built_in(), options);
    REQUIRE(solution);
    REQUIRE(solution->scene.objects.size() == 1);
    return (solution->scene.objects[0].position.head<2>() - Vec2(2, 2)).norm();
  };
  CHECK(distance(1.0) > 1.5);
  CHECK(distance(0.0) < 0.15);
}
