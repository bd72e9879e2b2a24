#include "solve/layout.h"

#include "support/brute_force.h"
#include "support/random_problem.h"
#include "support/solved.h"

using namespace roomgen;

TEST_CASE("What the cheap test refuses is wrong, and what both tests pass is right, by brute force") {
  Random random(1);
  int passed = 0, refused = 0;
  for (int i = 0; i < 250; ++i) {
    const Room room = rooms::random_room(random);
    const ModelTable models;
    Layout layout(room, KindTable::built_in(), models);
    Scene scene = rooms::scene(room, {});
    for (auto& task : rooms::random_tasks(random, room, 5)) {
      if (!task.object.traits.flat) task.object.traits.round = false;
      Pose pose;
      pose.position = shapes::random_point(random, -3, 4);
      pose.yaw = random.chance(0.5) ? layout.wall_yaws()[0] : random.uniform(-pi, pi);
      const Object object = at_pose(task.object, pose);
      const auto candidate = layout.candidate(object);
      const bool fits = layout.fits(candidate, footprint(object), 0.0);
      scene.objects.push_back(object);
      if (fits && layout.fits_exactly(candidate)) {
        ++passed;
        INFO("room " << i << ", " << object.id);
        CHECK(brute_force::faults(scene) == std::vector<std::string>{});
        layout.add(object);
      } else {
        ++refused;
        scene.objects.pop_back();
      }
    }
  }
  CHECK(passed > 150);
  CHECK(refused > 150);
}

TEST_CASE("Taking a thing out again leaves the layout as before") {
  Random random(2);
  const ModelTable models;
  const Room room = rooms::box(4, 4);
  Layout layout(room, KindTable::built_in(), models);
  const Object desk = rooms::thing("desk-0", "desk", {1.2, 0.6, 0.75}, {2, 3.6});
  const auto fits_there = [&] {
    const auto candidate = layout.candidate(desk);
    return layout.fits(candidate, footprint(desk), 0.0) && layout.fits_exactly(candidate);
  };
  CHECK(fits_there());
  layout.add(rooms::thing("plant-0", "plant", {0.4, 0.4, 0.9}, {2, 3.5}));
  CHECK_FALSE(fits_there());
  layout.remove("plant-0");
  CHECK(fits_there());
  CHECK(layout.objects().empty());
  layout.remove("never-there");
  CHECK(fits_there());
}

TEST_CASE("A pose is rounded as files hold it") {
  const Object placed = at_pose(rooms::thing("a-0", "a", {1, 1, 1}),
                                {{1.23456789, -0.00001}, 0.5, radians(12.3456789)});
  CHECK(placed.position == Vec3(1.2346, 0, 0.5));
  CHECK(degrees(placed.yaw) == Approx(12.346).epsilon(1e-12));
}

TEST_CASE("Yaws of walls are square to every wall, each once") {
  Random random(3);
  const ModelTable models;
  for (int i = 0; i < 50; ++i) {
    const Room room = rooms::random_room(random);
    const Layout layout(room, KindTable::built_in(), models);
    for (std::size_t k = 0; k < room.polygon.size(); ++k)
      for (int quarter = 0; quarter < 4; ++quarter) {
        const double wanted = yaw_facing(room.polygon.inward(k)) + quarter * pi / 2;
        int found = 0;
        for (double yaw : layout.wall_yaws()) found += std::cos(yaw - wanted) > 1 - 1e-12 ? 1 : 0;
        REQUIRE(found == 1);
      }
  }
}

TEST_CASE("However things came and went, the exact test says what the rules say of all of them") {
  Random random(3);
  const ModelTable models;
  const KindTable& kinds = KindTable::built_in();
  const std::vector<std::pair<std::string, Vec3>> articles = {{"desk", {1.2, 0.6, 0.75}}, {"chair", {0.5, 0.5, 0.9}},
                                                              {"wardrobe", {1, 0.6, 2}},  {"bed", {1.4, 2, 0.5}},
                                                              {"rug", {1, 1, 0.01}},      {"plant", {0.4, 0.4, 1}}};
  Room room = rooms::box(6, 5);
  room.openings.push_back(rooms::door("door-0", 0, 0.4, 1.3));
  Layout layout(room, kinds, models);
  const auto thrown = [&](const std::string& id) {
    const auto& [category, size] = random.pick(articles);
    Object object = rooms::thing(id, category, size, {random.uniform(0.4, 5.6), random.uniform(0.4, 4.6)},
                                 90.0 * random.integer(0, 3));
    object.traits.flat = category == "rug";
    return object;
  };
  // Of everybody from scratch.
  const auto is_right = [&](const Object& newcomer) {
    std::vector<Object> objects(layout.objects().begin(), layout.objects().end());
    Solids solids(models);
    for (const auto& other : objects)
      if (solids.overlap(newcomer, other)) return false;
    objects.push_back(newcomer);
    const auto things = floor_things(objects, kinds);
    if (!blocks_floor(newcomer, *things.back().category)) return true;
    const auto before = std::span(things).first(things.size() - 1);
    const auto ways = make_occupancy_grid(room, things);
    return ways.doors_connected() && std::all_of(things.begin(), things.end(), [&](const FloorThing& thing) {
             // What was of no use before is nobody's fault.
             const bool was_free = &thing == &things.back() || has_free_zone(room, before, thing);
             return !was_free || is_usable(room, things, thing, ways);
           });
  };
  int right = 0, wrong = 0;
  for (int step = 0; step < 400; ++step) {
    if (layout.objects().size() > 7 || (layout.objects().size() > 3 && random.chance(0.4)))
      layout.remove(std::string(layout.objects()[static_cast<std::size_t>(random.integer(
          0, static_cast<int>(layout.objects().size()) - 1))].id));
    const Object newcomer = thrown("thing-" + std::to_string(step));
    const bool fits = static_cast<bool>(layout.fits_exactly(layout.candidate(newcomer)));
    INFO("step " << step << ", " << newcomer.category);
    CHECK(fits == is_right(newcomer));
    ++(fits ? right : wrong);
    // Also what makes others useless comes in, as in rooms that somebody else furnished.
    if (fits || random.chance(0.1)) layout.add(newcomer);
  }
  CHECK(right > 40);
  CHECK(wrong > 40);
}
