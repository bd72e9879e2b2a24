#include <map>

#include "base/random.h"
#include "catch.h"
#include "roomgen/evaluate/report.h"
#include "roomgen/solve/solve.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

PlacementTask task(const std::string& id, const std::string& category, const Vec3& size,
                   const std::string& on = "") {
  PlacementTask result;
  Object& object = result.object;
  object.id = id;
  object.category = category;
  object.size = size;
  object.traits = KindTable::built_in().get(category).traits;
  if (on.empty()) return result;
  object.mount = Mount::surface;
  object.on = on;
  object.relations = {{RelationKind::on, on}};
  return result;
}

Problem room(double side) {
  Problem problem;
  problem.room.polygon.points = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  return problem;
}

// On what carries it, on its surface, and apart from the others there.
void check_supported(const Scene& scene) {
  for (const auto& object : scene.objects) {
    if (object.mount != Mount::surface) continue;
    const Object* support = find_object(scene, object.on);
    INFO(object.id << " on " << object.on);
    REQUIRE(support);
    CHECK(bottom(object) == Approx(top(*support)).margin(0.002));
    const Footprint base = footprint(object);
    for (const auto& corner : base.outline()) {
      const Vec2 local = footprint(*support).to_local(corner).cwiseAbs();
      CHECK((local - footprint(*support).half()).maxCoeff() <= 0.006);
    }
  }
  CHECK(examine(scene, ModelTable(), KindTable::built_in()).violations.empty());
}

}  // namespace

TEST_CASE("Random things on tables are supported, on the table and apart, or left out") {
  Random random(11);
  std::size_t placed = 0;
  for (int i = 0; i < 25; ++i) {
    Problem problem = room(4);
    problem.tasks = {task("table-0", "table", {random.uniform(0.5, 1.8), random.uniform(0.5, 0.9), 0.74})};
    problem.tasks[0].object.relations = {{RelationKind::middle, ""}};
    const int count = random.integer(1, 9);
    for (int k = 0; k < count; ++k) {
      const Vec3 size(random.uniform(0.05, 0.4), random.uniform(0.05, 0.3), random.uniform(0.02, 0.4));
      problem.tasks.push_back(task("vase-" + std::to_string(k), "vase", size, "table-0"));
    }
    SolveOptions options;
    options.rounds = 10;
    const auto solution = solve(problem, ModelTable(), KindTable::built_in(), options);
    REQUIRE(solution);
    placed += solution->scene.objects.size();
    check_supported(solution->scene);
  }
  CHECK(placed > 90);
}

TEST_CASE("Things stand on things on things") {
  Problem problem = room(4);
  problem.tasks = {task("table-0", "table", {1.2, 0.8, 0.74}),
                   task("tray-0", "tray", {0.45, 0.3, 0.03}, "table-0"),
                   task("book-0", "book", {0.25, 0.18, 0.03}, "tray-0"),
                   task("book-1", "book", {0.22, 0.16, 0.03}, "book-0")};
  const auto solution = solve(problem, ModelTable(), KindTable::built_in());
  REQUIRE(solution);
  CHECK(solution->scene.objects.size() == 4);
  check_supported(solution->scene);
}

TEST_CASE("More than a table holds is left out with the reason, and so is what is too large") {
  Problem problem = room(3);
  problem.tasks = {task("table-0", "table", {0.5, 0.5, 0.5})};
  for (int k = 0; k < 30; ++k)
    problem.tasks.push_back(task("book-" + std::to_string(k), "book", {0.28, 0.18, 0.03}, "table-0"));
  problem.tasks.push_back(task("tv-0", "tv", {1.1, 0.8, 0.6}, "table-0"));
  SolveOptions options;
  options.rounds = 5;
  const auto solution = solve(problem, ModelTable(), KindTable::built_in(), options);
  REQUIRE(solution);
  check_supported(solution->scene);
  CHECK(solution->scene.objects.size() >= 3);
  std::map<std::string, std::string> reasons;
  for (const auto& unplaced : solution->scene.unplaced) reasons[unplaced.id] = unplaced.reason;
  REQUIRE(reasons.count("tv-0"));
  CHECK(reasons["tv-0"].find("the largest is 0.5 x 0.5 m") != std::string::npos);
  CHECK(reasons.size() > 20);
  for (const auto& [id, reason] : reasons) {
    INFO(id << ": " << reason);
    if (id != "tv-0") CHECK(reason.find("leaves no room") != std::string::npos);
  }
}

TEST_CASE("A screen on a desk looks at who sits there") {
  Problem problem = room(4);
  problem.tasks = {task("desk-0", "desk", {1.4, 0.7, 0.74}), task("chair-0", "chair", {0.45, 0.45, 0.9}),
                   task("monitor-0", "monitor", {0.5, 0.2, 0.4}, "desk-0"),
                   task("keyboard-0", "keyboard", {0.4, 0.15, 0.03}, "desk-0")};
  problem.tasks[0].object.relations = {{RelationKind::edge, ""}};
  problem.tasks[1].object.relations = {{RelationKind::around, "desk-0"},
                                       {RelationKind::in_front_of, "desk-0"}};
  problem.tasks[3].object.relations.push_back({RelationKind::in_front_of, "monitor-0"});
  const auto solution = solve(problem, ModelTable(), KindTable::built_in());
  REQUIRE(solution);
  CHECK(solution->held == solution->constraints);
  check_supported(solution->scene);
  const Object* monitor = find_object(solution->scene, "monitor-0");
  const Object* chair = find_object(solution->scene, "chair-0");
  REQUIRE((monitor && chair));
  CHECK(std::abs(wrap_angle(monitor->yaw - chair->yaw - pi)) < 0.01);
}
