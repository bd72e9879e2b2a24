#include "library/qualifiers.h"

#include <algorithm>

#include "catch.h"
#include "library/looks.h"

using namespace roomgen;

namespace {

bool has(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string kind(const std::string& category, const std::string& description) {
  return own_name(category, description).kind;
}

}  // namespace

TEST_CASE("Words about parts and neighbours say nothing of the thing itself") {
  const auto table = qualify("a low oak dining table with round brass legs and a drawer beside the white sofa");
  CHECK(table.head == "low oak dining table");
  CHECK(has(table.own, "oak"));
  CHECK_FALSE(has(table.own, "round"));
  CHECK_FALSE(has(table.own, "table"));
  CHECK(has(table.parts, "round"));
  CHECK(has(table.parts, "drawer"));
  CHECK_FALSE(has(table.own, "white"));
  CHECK_FALSE(has(table.parts, "white"));
}

TEST_CASE("Words behind a comma or of what it is made qualify the thing, and so does its top") {
  for (const auto* text : {"dining table, round, walnut", "round dining table of dark walnut", "dining table in walnut, round",
                           "dining table with a round walnut top"}) {
    INFO(text);
    const auto table = qualify(text);
    CHECK(has(table.own, "round"));
    CHECK(has(table.own, "walnut"));
  }
  CHECK(wanted_looks("a square table with round knobs").outline == "square");
  CHECK(wanted_looks("a rectangular table with round brass legs").outline == "rectangular");
  CHECK(wanted_looks("a coffee table, oval").outline == "oval");
}

TEST_CASE("What a thing is said to have is demanded where it is used by it") {
  const auto demands = [](const std::string& text) { return wanted_looks(text).making; };
  CHECK(has(demands("a sideboard with white sliding doors and slim legs"), "doors"));
  CHECK(demands("a kitchen counter with a steel sink") == std::vector<std::string>{"sink"});
  CHECK(demands("a cooker with four hobs and an oven") == std::vector<std::string>{"four hobs"});
  CHECK(demands("a dish rack beside the sink").empty());
  CHECK(demands("a stool in front of the sink").empty());
  CHECK(demands("a dresser, six drawers") == std::vector<std::string>{"six drawers"});
}

TEST_CASE("The thing's own name goes before other words, and before a category that is none") {
  CHECK(kind("picture", "a paint-splattered canvas drop cloth with splashes") == "drop cloth");
  CHECK(kind("book", "a tall crooked pile of old leather-bound books on the floor") == "book stack");
  CHECK(kind("armchair", "armchair, office style") == "armchair");
  CHECK(kind("chair", "a blue office chair on castors") == "office chair");
  CHECK(kind("toy", "a large toy tyrannosaurus rex") == "plush dinosaur");
  CHECK(kind("printer", "a compact black office printer") == "printer");
  CHECK(kind("bed", "a bunk bed for two") == "bunk bed");
  // Kin, stuffs and what it is full of are no other names.
  CHECK(kind("coffee table", "glass and black metal") == "coffee table");
  CHECK(kind("pen holder", "a cup of coloured pencils") == "pen holder");
  CHECK(kind("kitchen sink", "a white base cabinet with a steel sink") == "kitchen sink");
  CHECK(kind("laptop", "on the desk") == "laptop");
}
