// What of a thing comes down to the floor. The table is a top on four legs of 6 cm.
#include "collision/low_parts.h"

#include "catch.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

ModelTable one_table() {
  auto model = std::make_shared<Model>();
  model->materials.resize(1);
  ModelPart part;
  append(part.mesh, make_box({-0.8, -0.4, 0.71}, {0.8, 0.4, 0.75}));
  for (const double x : {-0.8, 0.74})
    for (const double y : {-0.4, 0.34})
      append(part.mesh, make_box({x, y, 0}, {x + 0.06, y + 0.06, 0.71}));
  model->parts.push_back(part);
  ModelTable models;
  models.add("test/table", model);
  return models;
}

Object table_at(const Vec2& at, double yaw) {
  Object o = rooms::thing("table-0", "table", {1.6, 0.8, 0.75}, at, yaw);
  o.asset = {"test", "table", "", "", "", std::nullopt};
  return o;
}

}  // namespace

TEST_CASE("A table comes down with its legs, however it is turned") {
  const ModelTable models = one_table();
  for (const double yaw : {0.0, 30.0, 90.0}) {
    const Object object = table_at({2, 1}, yaw);
    const auto legs = low_parts(object, models, 0.02);
    REQUIRE(legs.size() == 4);
    for (const auto& leg : legs) {
      CHECK(leg.area() == Approx(0.06 * 0.06).epsilon(1e-3));
      const Vec2 local = footprint(object).to_local(leg.center()).cwiseAbs();
      CHECK(local.x() == Approx(0.77).margin(1e-4));
      CHECK(local.y() == Approx(0.37).margin(1e-4));
    }
  }
  CHECK(low_parts(table_at({0, 0}, 0), models, 0.73).size() == 1);
}

TEST_CASE("A box comes down with all of it, and what hangs does not") {
  Object chest = rooms::thing("chest-0", "chest", {1.0, 0.5, 0.5}, {1, 1});
  const auto parts = low_parts(chest, {}, 0.02);
  REQUIRE(parts.size() == 1);
  CHECK(parts.front().area() == Approx(0.5).epsilon(1e-3));
  chest.position.z() = 0.3;
  CHECK(low_parts(chest, {}, 0.02).empty());
}
