#include "base/random.h"
#include "catch.h"
#include "lab/sceneeval/geometric_relations.h"
#include "support/rooms.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

Thing raised(const Vec3& size, const Vec3& at, double yaw = 0.0) {
  Object object = rooms::thing("a-0", "thing", size, at.head<2>(), yaw);
  object.position.z() = at.z();
  return thing_of(object, ModelTable());
}

}  // namespace

TEST_CASE("A plant stands in its pot, not on it, beside it or on the same ground") {
  const Thing pot = raised({0.4, 0.4, 0.3}, {1, 1, 0.5});
  const Vec3 plant(0.3, 0.3, 0.9);
  CHECK(stands_in(raised(plant, {1, 1, 0.52}), pot) == 1.0);
  CHECK(stands_in(raised(plant, {1, 1, 0.8}), pot) == 0.0);
  CHECK(stands_in(raised(plant, {1.3, 1, 0.52}), pot) == 0.0);
  CHECK(stands_in(raised({0.4, 0.4, 0.5}, {1, 1, 0}), raised({1.2, 0.6, 0.75}, {1, 1, 0})) == 0.0);
}

TEST_CASE("Feet at random places agree with lengths in the pot's own frame") {
  Random random(5);
  const Thing pot = raised({0.6, 0.4, 0.3}, {0, 0, 0.2}, 30);
  for (int i = 0; i < 300; ++i) {
    const double x = random.uniform(-0.5, 0.5);
    const double y = random.uniform(-0.5, 0.5);
    const double z = random.uniform(0, 0.7);
    const double angle = std::atan2(y, x) - radians(30), length = std::hypot(x, y);
    const bool expected = std::abs(length * std::cos(angle)) < 0.3 &&
                          std::abs(length * std::sin(angle)) < 0.2 && z > 0.205 && z < 0.495;
    CHECK(stands_in(raised({0.3, 0.3, 0.9}, {x, y, z}, random.uniform(-180, 180)), pot) ==
          (expected ? 1.0 : 0.0));
  }
}
