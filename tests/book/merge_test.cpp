#include "book/merge.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/resource.h"
#include "book/book.h"
#include "book/planner.h"
#include "brief/prompt.h"
#include "catch.h"
#include "composition/plan_groups.h"

using namespace roomgen;

namespace {

const KindTable& kinds() {
  return KindTable::built_in();
}

brief::Brief brief_of(const std::string& wish) {
  return brief::read_prompt(wish, *brief::built_in_room_kinds(), kinds());
}

// A dining table with four chairs around it, a sofa with a lamp, two bookshelves, a picture.
book::Design dining_room() {
  const auto json =
      parse_json(R"({"name": "dining", "for": ["dining room"], "size_m": {"usual": [5.5, 4.5]},
    "openings": [{"kind": "door", "wall": "south", "at": 0.1, "width": 0.9}],
    "groups": [
      {"id": "dining", "stands": {"at": ["0.6*W", "D/2"], "facing": "south"}, "things": [
        {"part": "table", "name": "dining table", "description": "oak table", "size_cm": [180, 90, 75]},
        {"part": "chair", "name": "dining chair", "description": "oak chair", "quantity": 4, "where": "around table"},
        {"part": "vase", "name": "vase", "description": "blue vase", "where": "on table"}]},
      {"id": "sitting", "stands": {"wall": "west", "along": "D/2"}, "things": [
        {"part": "sofa", "name": "sofa", "description": "grey sofa", "size_cm": [180, 85, 80]},
        {"part": "lamp", "name": "floor lamp", "description": "black lamp", "where": "left of sofa", "gap_m": 0.1}]}],
    "objects": [
      {"name": "bookshelf", "description": "oak bookshelf", "quantity": 2, "place": "floor"},
      {"name": "picture", "description": "print", "place": "wall", "stands": {"wall": "north", "along": 2}, "bottom_m": 1.2}]})",
                 "test");
  return *book::read_design(*json, "test");
}

Plan plan_of(const std::string& wish, const book::Design& design, std::uint64_t seed = 1) {
  PlanRequest request;
  request.prompt = wish;
  request.seed = seed;
  const auto plan = book::plan_by_book(request, brief_of(wish), {&design});
  REQUIRE(plan);
  return *plan;
}

int count(const Plan& plan, const std::string& kind) {
  int number = 0;
  for (const auto& item : plan.items)
    if (kinds().is_a(item.category, kind)) number += item.quantity;
  return number;
}

const PlanItem* find(const Plan& plan, const std::string& kind) {
  for (const auto& item : plan.items)
    if (kinds().is_a(item.category, kind)) return &item;
  return nullptr;
}

}  // namespace

TEST_CASE("A design's own things become what a wish asks for") {
  const auto design = dining_room();
  SECTION("as many, in their group") {
    const Plan plan = plan_of("a dining room with a table and six chairs", design);
    CHECK(count(plan, "chair") == 6);
    CHECK(count(plan, "table") == 1);
    for (const auto& item : plan.items)
      if (kinds().is_a(item.category, "chair")) CHECK(!item.group.empty());
  }
  SECTION("as they shall look") {
    const Plan plan = plan_of("a dining room with a red velvet sofa", design);
    CHECK(count(plan, "sofa") == 1);
    CHECK(find(plan, "sofa")->description.find("red") != std::string::npos);
    CHECK(find(plan, "sofa")->asked);
    CHECK(!find(plan, "sofa")->group.empty());
  }
  SECTION("and nothing else stands for what is counted") {
    CHECK(count(plan_of("a dining room with one bookshelf", design), "bookshelf") == 1);
    CHECK(count(plan_of("a dining room with three bookshelves", design), "bookshelf") == 3);
  }
}

TEST_CASE("What a wish forbids goes, with what stands on it and what belongs to it") {
  const auto design = dining_room();
  const Plan plan = plan_of("a dining room without a table", design);
  CHECK(count(plan, "table") == 0);
  CHECK(count(plan, "vase") == 0);
  CHECK(count(plan, "dining chair") == 0);
  CHECK(count(plan, "sofa") == 1);
  CHECK(count(plan_of("a dining room, no sofa", design), "floor lamp") == 0);
}

TEST_CASE("A bare room holds nothing of the design but what is asked for") {
  const Plan plan = plan_of("a dining room with nothing but a table and two chairs", dining_room());
  CHECK(count(plan, "table") == 1);
  CHECK(count(plan, "chair") == 2);
  CHECK(planned_objects(plan).size() == 3);
}

TEST_CASE(
    "Every thing of a wish is in the plan, whatever the design has, and keeps its relations") {
  const auto design = dining_room();
  const std::string wishes[] = {
      "a dining room with a piano next to the door and two plants",
      "a dining room with a desk facing the window, a globe on the desk and a green rug",
      "a dining room with ten chairs, two tables and a fridge",
      "a dining room with a sofa opposite the bookshelf, three pictures and no lamps"};
  for (const auto& wish : wishes)
    for (const std::uint64_t seed : {1, 2, 3}) {
      INFO(wish << ", seed " << seed);
      const brief::Brief brief = brief_of(wish);
      const Plan plan = plan_of(wish, design, seed);
      for (const auto& mention : brief.mentions) {
        INFO(mention.category);
        CHECK(count(plan, mention.category) >= (mention.counted ? mention.quantity : 1));
        // Of a relation to another thing some object has it.
        for (const auto& demand : mention.demands) {
          const bool is_there =
              std::any_of(plan.items.begin(), plan.items.end(), [&](const PlanItem& item) {
                return kinds().is_a(item.category, mention.category) &&
                       std::any_of(
                           item.relations.begin(), item.relations.end(),
                           [&](const Relation& relation) { return relation.kind == demand.kind; });
              });
          CHECK(is_there);
        }
      }
      for (const auto& forbidden : brief.excluded) CHECK(count(plan, forbidden) == 0);
    }
}

TEST_CASE(
    "The designs of the book are sound, and become plans in which what makes the room has its "
    "place") {
  int looked_at = 0;
  for (const auto& path : book::built_in_names()) {
    INFO(path);
    const auto json = parse_json(*resource(path), std::string(path));
    REQUIRE(json);
    const auto design = book::read_design(*json, std::string(path));
    if (!design) FAIL(design.error().message);
    // Names are read from the first list that is called "for".
    const auto names = brief::rooms_of_design(*resource(path));
    REQUIRE(names.size() == design->rooms.size());
    CHECK(names.front() == brief::room_name(design->rooms.front()));
    CHECK((design->least.array() <= design->most.array()).all());
    if (++looked_at % 5 != 0) continue;
    const Plan plan = plan_of("a " + design->rooms.front(), *design);
    CHECK((design->is_plain || planned_objects(plan).size() > 4));
  }
  CHECK(looked_at > 150);
}
