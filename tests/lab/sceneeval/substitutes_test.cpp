// What stands in a room under the name of something else.
#include "catch.h"
#include "evaluate/attributes.h"
#include "evaluate/identity.h"
#include "evaluate/ledger.h"
#include "support/rooms.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

Object made_as(const std::string& kind) {
  Object object = rooms::thing(kind + "-0", kind, {0.4, 0.4, 0.8}, {1, 1});
  object.asset.procedural = ProceduralSource{"words", "{\"kind\": \"" + kind + "\"}", 0};
  return object;
}

// Of who asks for `noun` and gets a `kind` beside a table: the count, and that it is near the table.
std::vector<RequirementVerdict> verdicts(const std::string& noun, const std::string& kind) {
  Scene scene;
  scene.room = rooms::box(4, 4);
  scene.objects = {made_as(kind), made_as("table")};
  scene.objects[1].position = {2, 1, 0};
  Requirement count;
  count.kind = Requirement::Kind::count;
  count.category = kind;
  count.attribute = noun;
  count.subjects = {scene.objects[0].id};
  Requirement relation = count;
  relation.kind = Requirement::Kind::relation;
  relation.attribute.clear();
  relation.relation = RelationKind::near;
  relation.targets = {"table-0"};
  Requirement table = count;
  table.category = "table";
  table.attribute.clear();
  table.subjects = {"table-0"};
  const AttributeJudge by_label = [](const Object& object, const std::string& word) {
    AttributeVerdict verdict;
    verdict.held = identify(object).words.count(word) > 0;
    verdict.judged = verdict.held;
    return verdict;
  };
  return check_requirements(std::vector{count, relation, table}, scene, KindTable::built_in(), by_label);
}

}  // namespace

TEST_CASE("A kind is not counted as what it only looks like") {
  for (const auto& [noun, kind] : {std::pair{"harp", "guitar"}, {"flag", "poster"}, {"gavel", "mallet"}}) {
    INFO(noun);
    REQUIRE(KindTable::built_in().only_resembles(noun));
    CHECK(KindTable::built_in().named(noun)->name == kind);
    CHECK(identified_as({made_as(kind)}, {noun}).at(noun).empty());
    CHECK(identified_as({made_as(kind)}, {kind}).at(kind).size() == 1);
  }
}

TEST_CASE("What is said of a thing is not met by another one in its place") {
  for (const auto& [noun, kind] : {std::pair{"harp", "guitar"}, {"beret", "hat"}, {"decanter", "jug"}}) {
    INFO(noun);
    const auto all = verdicts(noun, kind);
    CHECK(all[0].compliance == Compliance::not_judged);
    CHECK(all[1].compliance == Compliance::not_judged);
    CHECK(all[1].reason == "nothing shows that " + std::string(kind) + "-0 is what was asked for");
    CHECK(all[2].met());
  }
  // Where it is what was asked for, both hold.
  const auto all = verdicts("guitar", "guitar");
  CHECK(all[0].met());
  CHECK(all[1].met());
}
