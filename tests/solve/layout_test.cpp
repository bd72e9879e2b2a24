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
