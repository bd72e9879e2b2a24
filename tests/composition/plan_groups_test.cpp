// Groups of plans: what completes them, and what is told of those that cannot be.
#include "composition/plan_groups.h"
#include "catch.h"
#include "roomgen/base/json.h"

#include <nlohmann/json.hpp>

using namespace roomgen;
using namespace roomgen::composition;

namespace {

Plan plan_with(const std::string& groups, const std::string& objects) {
  const std::string text =
      R"({"format": "roomgen-plan", "version": 1, "prompt": "x", "room": {"type": "room",
      "polygon": [[0, 0], [6, 0], [6, 5], [0, 5]], "openings": [{"id": "door-0", "type": "door", "wall": 0, "from": 1, "to": 1.9}]},
      "groups": )" +
      groups + R"(, "objects": )" + objects + "}";
  auto json = parse_json(text, "test");
  REQUIRE(json);
  auto plan = plan_from_json(*json, "test");
  if (!plan) INFO(plan.error().message);
  REQUIRE(plan);
  return *std::move(plan);
}

int count_of(const Plan& plan, const std::string& category, bool in_group) {
  int count = 0;
  for (const auto& item : plan.items)
    if (item.category == category && item.group.empty() != in_group) count += item.quantity;
  return count;
}

}  // namespace

TEST_CASE("A group has an item for each of its things, and what is too many stands for itself") {
  const Plan plan = completed(
      plan_with(
          R"([{"id": "dining", "composition": "dining table", "with": {"seats": 4}, "constraints": "middle"}])",
          R"([{"category": "dining table", "description": "oak", "group": "dining", "part": "table"},
                    {"category": "folding chair", "description": "red", "quantity": 6, "group": "dining", "part": "chair"}])"),
      KindTable::built_in());
  CHECK(count_of(plan, "folding chair", true) == 4);
  CHECK(count_of(plan, "folding chair", false) == 2);
  CHECK(count_of(plan, "dining table", true) == 1);
  CHECK(count_of(plan, "dining chair", true) == 0);
  CHECK(plan.items.front().relations == std::vector<Relation>{{RelationKind::middle, ""}});
  // The things of the group follow its anchor.
  const auto order = placing_order(plan);
  CHECK(order.size() == planned_objects(plan).size());
  CHECK(order.front().id == "dining table-0");
}

TEST_CASE("A completed plan is written and read again as it is") {
  const Plan plan = completed(
      plan_with(
          R"([{"id": "a", "composition": "bed with sides", "location": [3, 4], "facing": 90, "fixed": ["sides"]},
                    {"id": "b", "parts": [{"kind": "desk"}, {"kind": "office chair", "of": "desk", "at": [0, -0.6], "yaw": 180}]}])",
          "[]"),
      KindTable::built_in());
  const auto again = plan_from_json(to_json(plan), "again");
  REQUIRE(again);
  CHECK(to_json(completed(*again, KindTable::built_in())) == to_json(plan));
  CHECK(Roles(plan).by_id().size() == planned_objects(plan).size());
}

TEST_CASE("A group that cannot be made is told, and the rest is made") {
  for (
      const std::string group :
      {R"({"id": "g", "composition": "dining tabel"})",
       R"({"id": "g", "composition": "dining table", "with": {"seat": 4}})",
       R"({"id": "g", "parts": [{"kind": "table", "repeat": {"rows": 20, "columns": 20, "number": 500}}, {"kind": "chair", "around": "table", "count": 4}]})",
       R"({"id": "g", "parts": [{"kind": "table"}, {"kind": "chair"}]})"}) {
    INFO(group);
    const Plan plan = completed(
        plan_with("[" + group + "]",
                  R"([{"category": "table", "description": "x", "group": "g", "part": "table"},
        {"category": "sofa", "description": "y", "quantity": 1}])"),
        KindTable::built_in());
    CHECK(plan.groups.empty());
    REQUIRE(plan.notes.size() == 1);
    CHECK(plan.notes.front().find("\"g\"") != std::string::npos);
    CHECK(count_of(plan, "sofa", false) == 1);
    CHECK(count_of(plan, "table", false) == 1);
  }
}
