#include <set>

#include "catch.h"
#include "roomgen/generate/generate.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

// A table, or a pyramid on whose tip nothing stands.
std::shared_ptr<const Model> block(const Vec3& size, bool pyramid) {
  auto model = std::make_shared<Model>();
  model->materials.emplace_back();
  const Vec2 half = 0.5 * size.head<2>();
  Mesh mesh = make_box({-half.x(), -half.y(), 0}, {half.x(), half.y(), size.z()});
  if (pyramid)
    for (auto& p : mesh.positions)
      if (p.z() > 0.1f) p.head<2>() *= 0.01f;
  model->parts.push_back({std::move(mesh), 0});
  return model;
}

/// A library in which three assets are as good an answer to everything.
class Blocks final : public AssetLibrary {
 public:
  Result<std::vector<AssetMatch>> search(const AssetQuery& query) const override {
    std::vector<AssetMatch> matches;
    for (const char* id : {"a", "b", "c"}) {
      AssetMatch match;
      match.asset.ref.library = "blocks";
      match.asset.ref.id = id;
      match.asset.category = query.category;
      match.asset.size = query.mount == Mount::surface ? Vec3(0.2, 0.2, 0.2) : Vec3(0.6, 0.6, 0.6);
      match.score = pyramids && id != std::string("c") ? 0.95 : 0.8;
      matches.push_back(match);
    }
    return matches;
  }
  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override {
    return block({0.6, 0.6, 0.6}, pyramids && ref.id != "c");
  }

  bool pyramids = false;  ///< all but c
};

PlanItem item(const std::string& category, const std::string& description) {
  PlanItem result;
  result.category = category;
  result.description = description;
  result.mount = Mount::floor;
  result.asked = true;
  return result;
}

Plan plan_of(std::vector<PlanItem> items) {
  Plan plan;
  plan.prompt = "a test";
  plan.room = rooms::box(8, 8);
  plan.room.openings = {rooms::door("door-0", 0, 0.3, 1.2)};
  plan.items = std::move(items);
  return plan;
}

/// Places things wherever the solver likes them.
class Silent final : public Designer {
 public:
  Result<Plan> plan(const PlanRequest&) override { return Plan(); }
  Result<PlaceAdvice> place(const PlaceRequest& request) override {
    PlaceAdvice advice;
    advice.relations = request.plan.items[request.planned.item].relations;
    return advice;
  }
};

Scene furnish(const Plan& plan, const Blocks& library, std::uint64_t seed) {
  Silent designer;
  BuildOptions options;
  options.seed = seed;
  const auto generation = generate(plan, designer, library, KindTable::built_in(), options);
  REQUIRE(generation);
  return generation->scene;
}

}  // namespace

TEST_CASE("What is asked for in the same words shares its asset, in other words it need not") {
  std::set<std::string> white, black;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const auto scene = furnish(plan_of({item("chair", "white chair"), item("chair", "white chair"),
                                        item("chair", "black chair")}),
                               Blocks(), seed);
    REQUIRE(scene.objects.size() == 3);
    CHECK(scene.objects[0].asset.id == scene.objects[1].asset.id);
    white.insert(scene.objects[0].asset.id);
    black.insert(scene.objects[0].asset.id + scene.objects[2].asset.id);
  }
  CHECK(white.size() > 1);  // the seed decides
  CHECK(black.size() > 3);
}

TEST_CASE("Things that vary are each another asset, by the seed") {
  std::set<std::string> orders;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    PlanItem chairs = item("chair", "chair");
    chairs.quantity = 3;
    chairs.varied = true;
    std::string order;
    std::set<std::string> assets;
    for (const auto& chair : furnish(plan_of({chairs}), Blocks(), seed).objects) {
      order += chair.asset.id;
      assets.insert(chair.asset.id);
    }
    CHECK(assets.size() == 3);
    orders.insert(order);
  }
  CHECK(orders.size() > 1);
}

TEST_CASE("What shall carry a thing takes an asset that can") {
  PlanItem lamp = item("vase", "vase");
  lamp.mount = Mount::surface;
  lamp.size = Vec3(0.2, 0.2, 0.2);
  lamp.relations = {{RelationKind::on, "table-0"}};
  Blocks library;
  library.pyramids = true;
  CHECK(furnish(plan_of({item("table", "table")}), library, 1).objects[0].asset.id != "c");
  const auto scene = furnish(plan_of({item("table", "table"), lamp}), library, 1);
  REQUIRE(scene.objects.size() == 2);
  CHECK(scene.objects[0].asset.id == "c");
  CHECK(scene.objects[1].on == "table-0");
}
