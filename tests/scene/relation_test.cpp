#include "roomgen/scene/relation.h"

#include <limits>
#include <set>
#include <utility>

#include "catch.h"
#include "roomgen/base/file.h"
#include "scene/relation_table.h"
#include "support/contains.h"

using namespace roomgen;

namespace {

std::vector<RelationKind> all_kinds() {
  std::vector<RelationKind> kinds;
  for (const auto& relation : relation_definitions()) kinds.push_back(relation.kind);
  return kinds;
}

RelationKind kind_of(const std::string& text) {
  const auto relation = parse_relation(text + ", desk-0");
  INFO(text);
  REQUIRE(relation);
  CHECK(relation->target == "desk-0");
  return relation->kind;
}

std::string relation_complaint(std::string_view text) {
  const auto relations = parse_relations(text);
  if (relations) return "";
  CHECK(is_one_line(relations.error().message));
  return relations.error().message;
}

}  // namespace

TEST_CASE("Every kind has a name of its own that parses back to it") {
  std::set<std::string> names;
  for (const auto kind : all_kinds()) {
    Relation relation{kind, takes_target(kind) ? "bed-0" : ""};
    names.insert(std::string(name(kind)));
    const auto parsed = parse_relation(to_text(relation));
    INFO(to_text(relation));
    REQUIRE(parsed);
    CHECK(*parsed == relation);
  }
  CHECK(names.size() == relation_definitions().size());
  CHECK(names.count("") == 0);
}

TEST_CASE("No spelling means two relations") {
  std::set<std::string_view> seen;
  for (const auto& spelling : relation_spellings()) {
    INFO(spelling.text);
    CHECK(seen.insert(spelling.text).second);
    CHECK(parse_relation(std::string(spelling.text) + (spelling.kind == RelationKind::gap ? " 1 m" : "") + (takes_target(spelling.kind) ? ", x" : ""))->kind ==
          spelling.kind);
  }
}

TEST_CASE("The documentation says when each relation holds") {
  const auto text = read_file(std::string(ROOMGEN_SOURCE_DIR) + "/docs/constraints.md");
  REQUIRE(text);
  // The first column of the table.
  std::string documented;
  for (std::size_t row = text->find("\n| `"); row != std::string::npos; row = text->find("\n| `", row + 1))
    documented += text->substr(row + 2, text->find('|', row + 3) - row - 2);
  for (const auto& relation : relation_definitions())
    CHECK(contains_text(documented, "`" + std::string(relation.name()) + "`"));
}

TEST_CASE("Only edge, middle and corner take no target") {
  for (const auto kind : all_kinds())
    CHECK(takes_target(kind) == (kind != RelationKind::edge && kind != RelationKind::middle &&
                                 kind != RelationKind::corner));
}

TEST_CASE("Other common spellings are understood") {
  CHECK(parse_relation("against wall")->kind == RelationKind::edge);
  CHECK(parse_relation("center")->kind == RelationKind::middle);
  CHECK(kind_of("close to") == RelationKind::near);
  CHECK(kind_of("within") == RelationKind::inside);
  CHECK(kind_of("far from") == RelationKind::far);
  CHECK(kind_of("to the left of") == RelationKind::left_of);
  CHECK(kind_of("to the right of") == RelationKind::right_of);
  CHECK(kind_of("beside") == RelationKind::side_of);
  CHECK(kind_of("centre align with") == RelationKind::center_aligned);
  CHECK(kind_of("center aligned with") == RelationKind::center_aligned);
  CHECK(kind_of("aligned with") == RelationKind::aligned);
  CHECK(kind_of("facing") == RelationKind::face_to);
  CHECK(kind_of("on top of") == RelationKind::on);
  CHECK(kind_of("below") == RelationKind::under);
}

TEST_CASE("Case and extra spaces do not matter") {
  const Relation wanted{RelationKind::in_front_of, "office chair-0"};
  for (const char* text : {"in front of,office chair-0", "  In Front Of , Office Chair-0 ",
                           "in  front   of, office chair-0", "in\tfront of,\toffice chair-0"}) {
    const auto relation = parse_relation(text);
    INFO(text);
    REQUIRE(relation);
    CHECK(*relation == wanted);
  }
}

TEST_CASE("A list keeps its order and drops what is empty or repeated") {
  const auto relations = parse_relations(" edge || near, bed-0 | EDGE | near, bed-0 |");
  REQUIRE(relations);
  CHECK(to_text(*relations) == "edge | near, bed-0");
  CHECK(parse_relations("")->empty());
  CHECK(parse_relations(" | ")->empty());
}

TEST_CASE("A list as text parses back to the list") {
  std::vector<Relation> all;
  for (const auto kind : all_kinds()) all.push_back({kind, takes_target(kind) ? "wall-0" : ""});
  CHECK(*parse_relations(to_text(all)) == all);
}

TEST_CASE("A gap says how far, and parses back") {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const std::pair<const char*, Gap> said[] = {{"gap 0.5 m, desk-0", {0.5, 0.5}},
                                              {"gap at least 1.25 m, wall-2", {1.25, infinite}},
                                              {"gap at most 1 m, door-0", {0.0, 1.0}}};
  for (const auto& [text, gap] : said) {
    INFO(text);
    const auto relation = parse_relation(text);
    REQUIRE(relation);
    CHECK(relation->kind == RelationKind::gap);
    CHECK(relation->gap == gap);
    CHECK(to_text(*relation) == text);
  }
  for (const char* wrong : {"gap, desk-0", "gap wide, desk-0", "gap -1 m, desk-0", "gap 1e9 m, desk-0", "gap nan, desk-0", "gap 1 m"}) {
    INFO(wrong);
    CHECK_FALSE(parse_relation(wrong));
  }
}

TEST_CASE("An unknown word suggests the nearest known one") {
  CHECK(contains_text(relation_complaint("neer, bed-0"), "\"neer\"; did you mean \"near\"?"));
  CHECK(contains_text(relation_complaint("edge | in fron of, bed-0"), "did you mean \"in front of\"?"));
  CHECK(contains_text(relation_complaint("levitating, bed-0"), "unknown constraint \"levitating\""));
  CHECK_FALSE(contains_text(relation_complaint("levitating, bed-0"), "did you mean"));
}

TEST_CASE("A target too few and one too many are errors") {
  CHECK(contains_text(relation_complaint("near"), "needs a target"));
  CHECK(contains_text(relation_complaint("near,"), "needs a target"));
  CHECK(contains_text(relation_complaint("edge, wall-0"), "takes no target"));
}
