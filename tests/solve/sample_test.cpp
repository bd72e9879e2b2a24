#include "roomgen/solve/solve.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "support/brute_force.h"
#include "support/random_problem.h"
#include "support/rooms.h"
#include "support/solved.h"

using namespace roomgen;

namespace {

const std::string data = ROOMGEN_TEST_DATA;

Problem problem_of(const std::string& file) {
  auto problem = read_problem(data + "/" + file);
  if (!problem) FAIL(problem.error().message);
  return *std::move(problem);
}

template <typename Room>
Samples sampled(const Room& room, SampleOptions options) {
  auto samples = sample(room, ModelTable(), KindTable::built_in(), options);
  if (!samples) FAIL(samples.error().message);
  return *std::move(samples);
}

SampleOptions options_of(std::size_t count, std::uint64_t seed = 0, unsigned threads = 0) {
  SampleOptions options;
  options.count = count;
  options.solve.seed = seed;
  options.threads = threads;
  return options;
}

// Some thing stands 0.3 m or 45 degrees from where it is in the other.
bool differ(const Scene& a, const Scene& b) {
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    const Object &one = a.objects[i], &other = b.objects[i];
    if (one.mount != Mount::floor) continue;
    if (std::hypot(one.position.x() - other.position.x(), one.position.y() - other.position.y()) >= 0.3) return true;
    if (std::abs(std::remainder(one.yaw - other.yaw, 2 * pi)) >= pi / 4) return true;
  }
  return false;
}

std::vector<Scene> scenes_of(const Samples& samples) {
  std::vector<Scene> scenes;
  for (const auto& layout : samples.layouts) scenes.push_back(with_layout(samples.scene, layout));
  return scenes;
}

void check_layouts(const Samples& samples, int least_held) {
  for (std::size_t k = 0; k < samples.layouts.size(); ++k) {
    const Scene scene = with_layout(samples.scene, samples.layouts[k]);
    INFO("layout " << k);
    CHECK(violations(scene) == std::vector<std::string>{});
    CHECK(brute_force::faults(scene) == std::vector<std::string>{});
    const auto report = examine(scene, ModelTable(), KindTable::built_in());
    CHECK(report.relations_held() == samples.layouts[k].held);
    CHECK(samples.layouts[k].held >= least_held);
  }
}

PlacementTask wish(const std::string& id, const std::string& category, const Vec3& size, const std::string& relations) {
  PlacementTask task;
  task.object = rooms::thing(id, category, size);
  task.object.relations = *parse_relations(relations);
  return task;
}

}  // namespace

TEST_CASE("Every layout passes two judges that share nothing, and holds what the solution holds") {
  for (const char* name : {"balcony", "bedroom", "dining_room", "l_shaped", "living_room"}) {
    INFO(name);
    const auto problem = problem_of(std::string("solver-scenes/") + name + ".json");
    const auto samples = sampled(problem, options_of(60, 3));
    CHECK(samples.layouts.size() == 60);
    check_layouts(samples, solved(problem, 3).held);
  }
}

TEST_CASE("Layouts of random rooms with slanted walls are valid") {
  std::size_t found = 0;
  for (std::uint64_t seed = 100; seed < 108; ++seed) {
    INFO("random problem " << seed);
    const auto problem = rooms::random_problem(seed);
    auto options = options_of(12, seed);
    options.solve.rounds = 2;
    const auto samples = sampled(problem, options);
    check_layouts(samples, solved(problem, seed, 2).held);
    found += samples.layouts.size();
  }
  CHECK(found > 60);
}

TEST_CASE("Every two layouts are distinct") {
  const auto scenes = scenes_of(sampled(problem_of("solver-scenes/bedroom.json"), options_of(300)));
  REQUIRE(scenes.size() == 300);
  for (std::size_t i = 0; i < scenes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!differ(scenes[i], scenes[j])) FAIL_CHECK("layouts " << j << " and " << i);
}

TEST_CASE("Things that change places make no new layout") {
  Problem problem;
  problem.room = rooms::box(2.0, 1.6);
  for (const char* id : {"box-0", "box-1", "box-2"}) problem.tasks.push_back(wish(id, "box", {0.5, 0.5, 0.5}, "edge"));
  const auto scenes = scenes_of(sampled(problem, options_of(200)));
  REQUIRE(scenes.size() > 20);
  for (std::size_t i = 0; i < scenes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      std::vector<std::size_t> order = {0, 1, 2};
      do {
        Scene other = scenes[j];
        for (std::size_t k = 0; k < 3; ++k) other.objects[k] = scenes[j].objects[order[k]];
        if (!differ(scenes[i], other)) FAIL_CHECK("layouts " << j << " and " << i);
      } while (std::next_permutation(order.begin(), order.end()));
    }
}

TEST_CASE("The same layouts are drawn by any number of threads, and others for another seed") {
  const auto problem = problem_of("solver-scenes/living_room.json");
  const auto lines = [&](std::uint64_t seed, unsigned threads) {
    const auto samples = sampled(problem, options_of(150, seed, threads));
    std::string text;
    for (std::size_t i = 0; i < samples.layouts.size(); ++i) text += to_json(samples, i).dump() + "\n";
    return text;
  };
  const std::string one = lines(7, 1);
  CHECK(std::count(one.begin(), one.end(), '\n') == 150);
  CHECK(one == lines(7, 2));
  CHECK(one == lines(7, 5));
  CHECK(one != lines(8, 1));
  const auto few = sampled(problem, options_of(20, 7));
  for (std::size_t i = 0; i < 20; ++i) CHECK(one.find(to_json(few, i).dump() + "\n") != std::string::npos);
}

TEST_CASE("What there is to find in a small room is found") {
  Problem problem;
  problem.room = rooms::box(2.4, 1.8);
  problem.room.openings.push_back(rooms::door("door-0", 0, 0.2, 1.0));
  problem.tasks = {wish("shelf-0", "shelf", {0.8, 0.3, 1.2}, "edge"), wish("box-0", "box", {0.5, 0.4, 0.4}, "edge")};
  const auto samples = sampled(problem, options_of(5000));
  const auto scenes = scenes_of(samples);
  CHECK(scenes.size() < 1000);
  // Every valid pair of places along the walls, in steps of 0.1 m, beside some layout that was found.
  const auto at_walls = [&](Object object) {
    std::vector<Object> placed;
    for (const auto& wall : {0, 1, 2, 3}) {
      const Segment line = problem.room.polygon.edge(static_cast<std::size_t>(wall));
      const Vec2 inward = problem.room.polygon.inward(static_cast<std::size_t>(wall));
      for (double s = 0.5 * object.size.x() + 0.01; s < line.length() - 0.5 * object.size.x(); s += 0.1) {
        const Vec2 at = line.a + s * line.direction() + (0.5 * object.size.y() + 0.01) * inward;
        object.position = {at.x(), at.y(), 0.0};
        object.yaw = yaw_facing(inward);
        placed.push_back(object);
      }
    }
    return placed;
  };
  std::size_t valid = 0, covered = 0;
  for (const auto& shelf : at_walls(problem.tasks[0].object))
    for (const auto& box : at_walls(problem.tasks[1].object)) {
      const Scene scene = rooms::scene(problem.room, {shelf, box});
      if (!violations(scene).empty()) continue;
      ++valid;
      covered += std::any_of(scenes.begin(), scenes.end(), [&](const Scene& other) { return !differ(scene, other); });
    }
  REQUIRE(valid > 100);
  CHECK(static_cast<double>(covered) >= 0.99 * static_cast<double>(valid));
}

TEST_CASE("Too many layouts for a room end in bounded time with those that there are") {
  const auto samples = sampled(problem_of("rooms/92-only-the-door.json"), options_of(1000));
  CHECK_FALSE(samples.layouts.empty());
  CHECK(samples.layouts.size() < 100);
  CHECK(samples.drawn >= samples.layouts.size());
}

TEST_CASE("What finds no place in the solution is left out of every layout") {
  const auto problem = problem_of("rooms/90-too-large.json");
  const auto samples = sampled(problem, options_of(20));
  REQUIRE(samples.scene.unplaced.size() == 1);
  CHECK(samples.scene.objects.size() + 1 == problem.tasks.size());
  CHECK(samples.constraints == solved(problem).constraints);
  check_layouts(samples, solved(problem).held);
}

TEST_CASE("What is locked stays, and what stands on a thing goes along with it") {
  Scene scene = rooms::scene(rooms::box(4, 3.5), {rooms::thing("wardrobe-0", "wardrobe", {1, 0.6, 2}, {0.7, 3.18}),
                                                  rooms::thing("table-0", "table", {1.2, 0.8, 0.74}, {2.5, 1.2}),
                                                  rooms::thing("vase-0", "vase", {0.12, 0.12, 0.3}, {2.6, 1.3})});
  scene.objects[0].locked = true;
  scene.objects[2].mount = Mount::surface;
  scene.objects[2].on = "table-0";
  scene.objects[2].position.z() = 0.74;
  std::swap(scene.objects[1], scene.objects[2]);  // a file may name what carries a thing after it
  const auto samples = sampled(scene, options_of(100));
  REQUIRE(samples.layouts.size() == 100);
  check_layouts(samples, 0);
  for (const auto& layout : scenes_of(samples)) {
    const Object &table = *find_object(layout, "table-0"), &vase = *find_object(layout, "vase-0");
    CHECK(find_object(layout, "wardrobe-0")->position == scene.objects[0].position);
    CHECK(contains(footprint(table), Vec2(vase.position.head<2>())));
    CHECK(vase.position.z() == Approx(0.74).margin(1e-3));
  }
  find_object(scene, "vase-0")->locked = true;
  CHECK(sampled(scene, options_of(100)).layouts.size() == 1);
}

TEST_CASE("What stands on a rug stays on it, and what stands beside it stays beside it") {
  Scene scene = rooms::scene(rooms::box(4.5, 4),
                             {rooms::thing("rug-0", "rug", {1.8, 1.4, 0.02}, {2, 2}),
                              rooms::thing("coffee table-0", "coffee table", {0.8, 0.5, 0.4}, {2, 2}),
                              rooms::thing("plant-0", "plant", {0.4, 0.4, 0.8}, {4, 3.5})});
  scene.objects[0].traits = {false, true, false};
  scene.objects[0].relations = *parse_relations("near, coffee table-0");
  scene.objects[1].position.z() = 0.02;
  const auto samples = sampled(scene, options_of(50));
  CHECK(samples.layouts.size() == 50);
  for (const auto& layout : scenes_of(samples)) {
    const Object& rug = *find_object(layout, "rug-0");
    const Footprint table = footprint(*find_object(layout, "coffee table-0"));
    for (const auto& corner : table.outline())
      CHECK(gap(footprint(rug), corner) < 2e-3);
    CHECK_FALSE(overlaps(footprint(rug), footprint(*find_object(layout, "plant-0"))));
  }
}

TEST_CASE("A room that breaks a rule by what is locked has no layouts") {
  Scene scene = rooms::scene(rooms::box(4, 3), {rooms::thing("box-0", "box", {1, 1, 1}, {1, 1}),
                                                rooms::thing("box-1", "box", {1, 1, 1}, {1.5, 1}),
                                                rooms::thing("box-2", "box", {1, 1, 1}, {3, 2})});
  scene.objects[0].locked = scene.objects[1].locked = true;
  CHECK(sampled(scene, options_of(10)).layouts.empty());
}

TEST_CASE("Where nothing is said a thing is everywhere, as if it were thrown") {
  const Room room = rooms::box(5, 4);
  const Scene scene = rooms::scene(room, {rooms::thing("box-0", "box", {0.4, 0.4, 0.4}, {1, 1})});
  auto options = options_of(60);
  options.apart = {0.05, 3.0};
  Vec2 mean = Vec2::Zero(), square = Vec2::Zero();
  const auto scenes = scenes_of(sampled(scene, options));
  REQUIRE(scenes.size() == 60);
  for (const auto& layout : scenes) {
    const Vec2 at = layout.objects[0].position.head<2>();
    mean += at / 60.0, square += at.cwiseProduct(at) / 60.0;
  }
  // Of a uniform place the deviation is the width over the square root of twelve.
  const Vec2 deviation = (square - mean.cwiseProduct(mean)).cwiseSqrt();
  CHECK(deviation.x() > 0.8 * 4.6 / std::sqrt(12.0));
  CHECK(deviation.y() > 0.8 * 3.6 / std::sqrt(12.0));
}

TEST_CASE("A line says where everything stands, and is read as the same layout") {
  const auto problem = problem_of("solver-scenes/l_shaped.json");
  const auto samples = sampled(problem, options_of(5));
  REQUIRE(samples.layouts.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    const auto read = scene_of_layout(to_json(samples, i), things_of(problem), "line");
    REQUIRE(read);
    CHECK_FALSE(differ(*read, with_layout(samples.scene, samples.layouts[i])));
    CHECK(examine(*read, ModelTable(), KindTable::built_in()).relations_held() == samples.layouts[i].held);
  }
  Json twice = to_json(samples, 0);
  twice["objects"].push_back(twice["objects"][0]);
  CHECK_FALSE(scene_of_layout(twice, things_of(problem), "line"));
  Json unknown = to_json(samples, 0);
  unknown["objects"][0]["id"] = "unicorn-0";
  CHECK_FALSE(scene_of_layout(unknown, things_of(problem), "line"));
}

TEST_CASE("More things than are varied, and more layouts than are kept, are refused with what to do") {
  Scene scene = rooms::scene(rooms::box(4, 3), {});
  for (std::size_t i = 0; i <= most_sampled_things; ++i)
    scene.objects.push_back(rooms::thing("box-" + std::to_string(i), "box", {0.1, 0.1, 0.1}, {2, 1.5}));
  auto options = options_of(10);
  options.solve.cancel.cancel();
  const auto refusal_of = [&] {
    const auto samples = sample(scene, ModelTable(), KindTable::built_in(), options);
    if (samples) return std::string();
    CHECK(samples.error().kind == Error::Kind::limit);
    return samples.error().message;
  };
  CHECK(refusal_of().find("up to 300 things, and this has 301") != std::string::npos);
  scene.objects.pop_back();
  CHECK(refusal_of() == "");
  options.count = most_sampled_poses / scene.objects.size() + 1;
  CHECK(refusal_of().find("draw up to " + std::to_string(options.count - 1)) != std::string::npos);
}

TEST_CASE("A draw that is stopped ends at once") {
  auto options = options_of(100000);
  options.solve.cancel.cancel();
  CHECK(sampled(problem_of("solver-scenes/living_room.json"), options).layouts.empty());
}
