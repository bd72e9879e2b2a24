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

TEST_CASE("Things of a group are put up as their place says, not as their kind is used to") {
  const Plan plan = completed(
      plan_with(
          R"([{"id": "g", "parts": [{"kind": "table"}, {"kind": "vase", "beside": "table", "side": "left"},
          {"kind": "teapot", "on": "table"}, {"kind": "cup", "beside": "teapot", "side": "right"},
          {"kind": "wall lamp", "beside": "table", "side": "right"}, {"kind": "mirror", "of": "table", "at": [0, 1]}]},
          {"id": "b", "parts": [{"kind": "water heater"}]}])",
          R"([{"category": "water heater", "description": "x", "size": [1.3, 1.3, 2.4], "group": "b", "part": "water heater"},
          {"category": "mirror", "description": "x", "lean": 10, "group": "g", "part": "mirror"}])"),
      KindTable::built_in());
  std::map<std::string, Mount> mounts;
  for (const auto& item : plan.items) mounts[item.category] = item.mount;
  CHECK(mounts["vase"] == Mount::floor);
  CHECK(mounts["cup"] == Mount::surface);
  CHECK(mounts["wall lamp"] == Mount::wall);
  CHECK(mounts["water heater"] == Mount::floor);
  CHECK(mounts["mirror"] == Mount::floor);
  CHECK(carriers(plan, KindTable::built_in()).at("cup-0") == "table-0");
}

TEST_CASE("Chairs deeper than their table keep it off no wall, and nor do they what hangs over it") {
  const Plan plan = completed(
      plan_with(
          R"([{"id": "g", "parts": [{"kind": "side table", "size": [0.45, 0.45, 0.6]},
          {"kind": "chair", "size": [0.5, 0.6, 0.9], "beside": "side table", "side": "sides", "count": 1},
          {"kind": "mirror", "size": [0.8, 0.04, 1.0], "above": "side table"}]}])",
          "[]"),
      KindTable::built_in());
  const auto ways = ways_to_stand(plan, plan.groups.front(), KindTable::built_in(), {});
  REQUIRE(ways);
  REQUIRE(ways->size() > 1);
  for (const auto& member : (*ways)[1].members)
    CHECK(member.place.position.y() + 0.5 * member.size.y() == Approx(0.225));
}
