#include "collision/support_poses.h"

#include <set>

#include "base/random.h"
#include "catch.h"

using namespace roomgen;

namespace {

Object thing(const std::string& id, const Vec3& size, bool round = false) {
  Object object;
  object.id = id;
  object.category = "thing";
  object.size = size;
  object.traits.round = round;
  return object;
}

}  // namespace

TEST_CASE("On a box, things rest on its top with their whole footprint") {
  Random random(2);
  const ModelTable models;
  const SupportPoses poses(models);
  int found = 0;
  for (int i = 0; i < 60; ++i) {
    const Object support = thing("support", {random.uniform(0.3, 1.5), random.uniform(0.3, 1), 0.7});
    const Object small = thing(
        "small", {random.uniform(0.05, 0.6), random.uniform(0.05, 0.6), random.uniform(0.02, 0.5)},
        random.chance(0.4));
    for (const auto& pose : poses.everywhere(small, support)) {
      ++found;
      CHECK(pose.bottom == Approx(0.7).margin(1e-6));
      const Footprint own(pose.position, small.size.head<2>(), pose.yaw, small.traits.round);
      const bool larger = small.size.head<2>().maxCoeff() > support.size.head<2>().minCoeff();
      // What is as wide as the support may hang over by a tenth.
      const double slack = larger ? 0.06 : 0.045;
      for (const auto& corner : own.outline())
        CHECK((corner.cwiseAbs() - 0.5 * support.size.head<2>()).maxCoeff() <= slack);
    }
  }
  CHECK(found > 1000);
}

TEST_CASE("What is larger than a surface rests nowhere, and neither does anything on a rug") {
  const ModelTable models;
  const SupportPoses poses(models);
  const Object table = thing("table", {0.6, 0.6, 0.5});
  CHECK(poses.everywhere(thing("large", {0.9, 0.9, 0.2}), table).empty());
  CHECK_FALSE(poses.everywhere(thing("small", {0.3, 0.3, 0.2}), table).empty());
  Object rug = thing("rug", {2, 2, 0.01});
  rug.traits.flat = true;
  CHECK(poses.everywhere(thing("small", {0.3, 0.3, 0.2}), rug).empty());
}

TEST_CASE("Between the boards of a shelf stands what is lower than the next board") {
  Mesh mesh;
  for (double x : {-0.4, 0.38}) append(mesh, make_box({x, -0.15, 0}, {x + 0.02, 0.15, 1.3}));
  for (double z : {0.0, 0.4, 0.8, 1.28}) append(mesh, make_box({-0.4, -0.15, z}, {0.4, 0.15, z + 0.02}));
  auto model = std::make_shared<Model>();
  model->materials.emplace_back();
  model->parts.push_back({mesh, 0});
  ModelTable models;
  Object shelf = thing("shelf", {0.8, 0.3, 1.3});
  shelf.asset.library = "test";
  shelf.asset.id = "shelf";
  models.add(asset_key(shelf.asset), model);
  const SupportPoses poses(models);
  const auto levels = [&](double height) {
    std::set<int> found;
    for (const auto& pose : poses.everywhere(thing("box", {0.2, 0.2, height}), shelf))
      found.insert(static_cast<int>(std::lround(100 * pose.bottom)));
    return found;
  };
  CHECK(levels(0.3) == std::set<int>{2, 42, 82, 130});
  CHECK(levels(0.42) == std::set<int>{82, 130});
  CHECK(levels(0.6) == std::set<int>{130});
}

//   +------+   A cabinet with two boards, closed all round; its doors are of glass or of wood.
//   |------|
//   |------|
//   +------+
TEST_CASE("Things stand behind doors of glass, and not behind doors of wood") {
  const auto boards_within = [](float opacity) {
    Mesh wood, doors;
    for (double x : {-0.4, 0.38}) append(wood, make_box({x, -0.2, 0}, {x + 0.02, 0.2, 1.2}));
    append(wood, make_box({-0.4, 0.18, 0}, {0.4, 0.2, 1.2}));
    for (double z : {0.0, 0.4, 0.8, 1.18})
      append(wood, make_box({-0.4, -0.19, z}, {0.4, 0.2, z + 0.02}));
    append(doors, make_box({-0.4, -0.2, 0}, {0.4, -0.19, 1.2}));
    auto model = std::make_shared<Model>();
    model->materials.resize(2);
    model->materials[1].base_color[3] = opacity;
    model->parts = {{wood, 0}, {doors, 1}};
    ModelTable models;
    Object cabinet = thing("cabinet", {0.8, 0.4, 1.2});
    cabinet.asset.library = "test";
    cabinet.asset.id = "cabinet";
    models.add(asset_key(cabinet.asset), model);
    const SupportPoses poses(models);
    std::set<int> levels;
    for (const auto& pose : poses.everywhere(thing("vase", {0.1, 0.1, 0.2}), cabinet))
      levels.insert(static_cast<int>(std::lround(100 * pose.bottom)));
    return levels;
  };
  CHECK(boards_within(0.3f) == std::set<int>{2, 42, 82, 120});
  CHECK(boards_within(1.0f) == std::set<int>{120});
}
