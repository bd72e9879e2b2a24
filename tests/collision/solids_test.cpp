// Solids by their meshes. The table is a top of 4 cm on four legs:
//
//   =====================   0.75 high
//   ||                 ||
//   ||                 ||
//  1.6 x 0.8 m, legs of 6 cm
#include "collision/solids.h"

#include "catch.h"
#include "support/rooms.h"
#include "support/shapes.h"

using namespace roomgen;

namespace {

std::shared_ptr<Model> model_of(const std::vector<std::pair<Vec3, Vec3>>& boxes) {
  auto model = std::make_shared<Model>();
  model->materials.resize(1);
  ModelPart part;
  for (const auto& [low, high] : boxes) append(part.mesh, make_box(low, high));
  model->parts.push_back(part);
  return model;
}

ModelTable furniture() {
  ModelTable models;
  const double x = 0.8, y = 0.4, leg = 0.06;
  models.add("test/table", model_of({{{-x, -y, 0.71}, {x, y, 0.75}},
                                     {{-x, -y, 0}, {-x + leg, -y + leg, 0.71}},
                                     {{x - leg, -y, 0}, {x, -y + leg, 0.71}},
                                     {{-x, y - leg, 0}, {-x + leg, y, 0.71}},
                                     {{x - leg, y - leg, 0}, {x, y, 0.71}}}));
  models.add("test/chair", model_of({{{-0.22, -0.22, 0.4}, {0.22, 0.22, 0.45}},
                                     {{-0.22, 0.18, 0.45}, {0.22, 0.22, 0.9}},
                                     {{-0.22, -0.22, 0}, {-0.18, -0.18, 0.4}},
                                     {{0.18, -0.22, 0}, {0.22, -0.18, 0.4}},
                                     {{-0.22, 0.18, 0}, {-0.18, 0.22, 0.4}},
                                     {{0.18, 0.18, 0}, {0.22, 0.22, 0.4}}}));
  return models;
}

Object table(const Vec2& at = {0, 0}, double yaw = 0) {
  Object o = rooms::thing("table-0", "table", {1.6, 0.8, 0.75}, at, yaw);
  o.asset = {"test", "table", "", "", "", std::nullopt};
  return o;
}

Object chair(const Vec2& at, double yaw = 180) {
  Object o = rooms::thing("chair-0", "chair", {0.44, 0.44, 0.9}, at, yaw);
  o.asset = {"test", "chair", "", "", "", std::nullopt};
  return o;
}

// With everything turned together, and in either order.
bool overlap(const Object& a, const Object& b) {
  static const ModelTable models = furniture();
  Solids solids(models);
  const bool first = solids.overlap(a, b);
  for (double degree : {0.0, 33.0, 90.0, 201.0}) {
    const double angle = radians(degree);
    const Vec2 shift(0.01 * degree, 1);
    INFO("turned by " << degree);
    CHECK(solids.overlap(rooms::moved(a, angle, shift), rooms::moved(b, angle, shift)) == first);
    CHECK(solids.overlap(rooms::moved(b, angle, shift), rooms::moved(a, angle, shift)) == first);
  }
  return first;
}

}  // namespace

TEST_CASE("A chair slides under a table top until its back meets the edge") {
  //    ==============
  //    ||     |_ |  ||
  //    ||     | ||  ||
  CHECK_FALSE(overlap(table(), chair({0, -0.45})));  // the seat is under the top, the back before it
  CHECK(boxes_overlap(table(), chair({0, -0.45})));
  CHECK(overlap(table(), chair({0, -0.2})));         // the back goes through the top
}

TEST_CASE("A chair does not slide through a leg") {
  CHECK(overlap(table(), chair({0.75, -0.45})));
}

TEST_CASE("A box that only fits by its mesh is judged by its mesh") {
  const auto crate = [](double height) {
    return rooms::thing("crate-0", "thing", {0.5, 0.4, height}, {0, 0});
  };
  CHECK_FALSE(overlap(table(), crate(0.6)));
  CHECK(overlap(table(), crate(0.74)));
}

TEST_CASE("Meshes that interlock by up to 5 mm count as apart, by 12 mm not") {
  //  The crate stands against the leg's side.
  const auto crate = [](double depth_into_leg) {
    return rooms::thing("crate-0", "thing", {0.3, 0.06, 0.5},
                        {0.8 - 0.06 - 0.15 + depth_into_leg, -0.37});
  };
  CHECK_FALSE(overlap(table(), crate(-0.01)));
  CHECK_FALSE(overlap(table(), crate(0.002)));
  CHECK(overlap(table(), crate(0.012)));
}

TEST_CASE("What is wholly inside another overlaps it, though no surfaces meet") {
  const Object wardrobe = rooms::thing("wardrobe-0", "wardrobe", {1.2, 0.6, 2.0}, {0, 0});
  Object shoe = rooms::thing("shoe-0", "thing", {0.2, 0.2, 0.2}, {0.1, 0});
  shoe.position.z() = 0.5;
  CHECK(overlap(wardrobe, shoe));
}

TEST_CASE("A model is scaled to its object's size, axis by axis") {
  //  The table twice as high: a wardrobe of 1.4 m fits under it.
  Object high = table();
  high.size = {1.6, 0.8, 1.5};
  const Object crate = rooms::thing("crate-0", "thing", {0.5, 0.4, 1.3}, {0, 0});
  CHECK_FALSE(overlap(high, crate));
  CHECK(overlap(table(), crate));
  // Twice as wide: its legs stand elsewhere.
  Object wide = table();
  wide.size = {3.2, 0.8, 0.75};
  const Object at_old_leg = rooms::thing("crate-0", "thing", {0.1, 0.1, 0.5}, {0.76, -0.36});
  CHECK(overlap(table(), at_old_leg));
  CHECK_FALSE(overlap(wide, at_old_leg));
}

TEST_CASE("A model without triangles counts as its box") {
  ModelTable models;
  models.add("test/empty", std::make_shared<Model>());
  Solids solids(models);
  Object empty = rooms::thing("a-0", "thing", {1, 1, 1}, {0, 0});
  empty.asset = {"test", "empty", "", "", "", std::nullopt};
  CHECK(solids.overlap(empty, rooms::thing("b-0", "thing", {1, 1, 1}, {0.5, 0})));
  CHECK_FALSE(solids.overlap(empty, rooms::thing("b-0", "thing", {1, 1, 1}, {1.5, 0})));
}

TEST_CASE("Whether two things overlap does not depend on which is named first") {
  Random random(1);
  const ModelTable models = furniture();
  Solids solids(models);
  int overlapping = 0, differing = 0;
  for (int i = 0; i < 1000; ++i) {
    const Object a = table(), b = chair(shapes::random_point(random, -1, 1), random.uniform(-180, 180));
    const bool first = solids.overlap(a, b);
    overlapping += first ? 1 : 0;
    differing += first != solids.overlap(b, a) ? 1 : 0;
  }
  CHECK(overlapping > 100);
  CHECK(overlapping < 900);
  CHECK(differing == 0);
}

TEST_CASE("What was asked before changes no answer") {
  //  Chairs about two tables that stand elsewhere and otherwise: many meet in equal ways.
  Random random(2);
  const ModelTable models = furniture();
  Solids experienced(models);
  int overlapping = 0, differing = 0;
  for (int i = 0; i < 300; ++i) {
    const double angle = radians(15.0 * random.integer(0, 23));
    const Vec2 shift(0.1 * random.integer(-20, 20), 0.1 * random.integer(-20, 20));
    const Vec2 at(0.1 * random.integer(-12, 12), 0.1 * random.integer(-9, 9));
    const Object a = rooms::moved(table(), angle, shift);
    const Object b = rooms::moved(chair(at, 90.0 * random.integer(0, 3)), angle, shift);
    Solids fresh(models);
    const bool first = fresh.overlap(a, b);
    overlapping += first ? 1 : 0;
    differing += experienced.overlap(a, b) != first || experienced.overlap(b, a) != first ? 1 : 0;
  }
  CHECK(overlapping > 50);
  CHECK(overlapping < 250);
  CHECK(differing == 0);
}
