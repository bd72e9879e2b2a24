#include <nlohmann/json.hpp>
#include <set>

#include "catch.h"
#include "roomgen/base/json.h"
#include "roomgen/create/create.h"
#include "roomgen/design/designer.h"
#include "roomgen/evaluate/report.h"
#include "roomgen/generate/generate.h"

using namespace roomgen;

TEST_CASE("A dwelling is furnished room by room into one sound scene") {
  const auto designer = make_rule_designer();
  PlanRequest request;
  request.prompt = "a bedroom with a desk and an en-suite bathroom. The bathroom has no rug.";
  request.seed = 3;
  const auto plan = plan_dwelling(request, *designer);
  REQUIRE(plan);
  REQUIRE(*plan);
  const auto library = create::make_created_library();
  const auto made = generate(**plan, *designer, *library, KindTable::built_in());
  REQUIRE(made);
  const Scene& scene = made->scene;
  REQUIRE(scene.rooms.size() == 2);
  CHECK(check(scene));
  CHECK(examine(scene, made->models, KindTable::built_in()).violations.empty());

  std::set<std::string> ids, furnished;
  for (const auto& object : scene.objects) {
    CHECK(ids.insert(object.id).second);
    furnished.insert(object.room);
  }
  CHECK(furnished.size() == 2);
  // Requirements of all rooms are in one ledger, each with its room.
  bool desk = false;
  for (const auto& verdict : scene.requirements) {
    // But for those about the number of rooms.
    CHECK(verdict.requirement.room.empty() == (verdict.requirement.attribute == "rooms"));
    if (verdict.requirement.category == "desk") {
      desk = true;
      CHECK(verdict.met());
      CHECK(verdict.requirement.room == "bedroom-0");
    }
  }
  CHECK(desk);
  CHECK(scene_from_json(to_json(scene), "scene.json"));
}

TEST_CASE("A dwelling that is stopped says so and keeps what stands") {
  const auto designer = make_rule_designer();
  PlanRequest request;
  request.prompt = "a bedroom with an en-suite bathroom";
  const auto plan = plan_dwelling(request, *designer);
  REQUIRE(plan);
  BuildOptions options;
  int steps = 0;
  options.on_event = [&](const BuildEvent&) {
    if (++steps == 3) options.cancel.cancel();
  };
  const auto library = create::make_created_library();
  const auto made = generate(**plan, *designer, *library, KindTable::built_in(), options);
  REQUIRE(made);
  CHECK(made->scene.incomplete);
  CHECK(made->scene.rooms.size() == 2);
  CHECK(made->scene.objects.size() <= 3);
  CHECK(check(made->scene));
}
