#include "catch.h"
#include "collision/solids.h"
#include "support/brute_force.h"

using namespace roomgen;

namespace {

Object random_object(Random& random, const std::string& id) {
  Object o = rooms::thing(id, "thing",
                          {random.uniform(0.2, 1.5), random.uniform(0.2, 1.5), random.uniform(0.2, 1.5)},
                          shapes::random_point(random, -1, 1), random.uniform(-180, 180));
  o.position.z() = random.uniform(0, 1);
  o.traits.round = random.chance(0.3);
  return o;
}

}  // namespace

TEST_CASE("Boxes and cylinders that share a sampled point overlap, and those clearly apart do not") {
  Random random(1);
  const ModelTable models;
  Solids solids(models);
  int shared_count = 0, apart_count = 0;
  for (int i = 0; i < 1500; ++i) {
    const Object a = random_object(random, "a"), b = random_object(random, "b");
    const bool in_height = brute_force::heights_overlap(a, bottom(b) + 0.01, top(b) - 0.01);
    double deepest = 0.0, nearest = 1e9;
    for (const auto& p : brute_force::points_of(a)) deepest = std::min(deepest, brute_force::outside_by(b, p));
    for (const auto& p : brute_force::points_of(b)) deepest = std::min(deepest, brute_force::outside_by(a, p));
    nearest = gap(footprint(a), footprint(b));
    INFO("pair " << i);
    if (in_height && deepest < -0.03) {
      ++shared_count;
      REQUIRE(boxes_overlap(a, b));
      REQUIRE(solids.overlap(a, b));
    }
    if (nearest > 0.0 || top(a) <= bottom(b) || top(b) <= bottom(a)) {
      ++apart_count;
      if (!a.traits.round && !b.traits.round) REQUIRE_FALSE(boxes_overlap(a, b));
      REQUIRE_FALSE(solids.overlap(a, b));
    }
  }
  CHECK(shared_count > 200);
  CHECK(apart_count > 200);
}

TEST_CASE("Boxes that touch do not overlap, on the side or on top") {
  const Object a = rooms::thing("a", "thing", {1, 1, 1}, {0, 0}, 30);
  Object b = rooms::moved(rooms::thing("b", "thing", {1, 1, 1}, {1, 0}), radians(30), {0, 0});
  CHECK_FALSE(boxes_overlap(a, b));
  b = a;
  b.position.z() = 1.0;
  CHECK_FALSE(boxes_overlap(a, b));
  b.position.z() = 0.99;
  CHECK(boxes_overlap(a, b));
}

TEST_CASE("A rug is no solid, whatever lies over it") {
  Object rug = rooms::thing("rug", "rug", {2, 2, 0.02}, {0, 0});
  rug.traits.flat = true;
  const Object table = rooms::thing("table", "table", {1, 1, 0.7}, {0, 0});
  const ModelTable models;
  Solids solids(models);
  CHECK_FALSE(both_solid(rug, table));
  CHECK_FALSE(solids.overlap(rug, table));
  CHECK_FALSE(solids.overlap(table, rug));
  CHECK_FALSE(solids.overlap(rug, rug));
}
