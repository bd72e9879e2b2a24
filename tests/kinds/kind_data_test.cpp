// The table that is compiled into the library.
#include "catch.h"
#include "roomgen/base/file.h"
#include "roomgen/kinds/kind_table.h"

using namespace roomgen;

TEST_CASE("data/categories.json parses, and the library holds all of it") {
  const auto text = read_file(ROOMGEN_SOURCE_DIR "/data/categories.json");
  REQUIRE(text);
  const auto table = KindTable::parse(*text, "data/categories.json");
  INFO((table ? "" : table.error().message));
  REQUIRE(table);
  CHECK(table->all().size() > 100);
  for (const auto& [name, category] : table->all()) CHECK(KindTable::built_in().find(name)->name == name);
}

TEST_CASE("Every category is found by its own name, its plural and its synonyms") {
  const auto& table = KindTable::built_in();
  for (const auto& [name, category] : table.all()) {
    INFO(name);
    REQUIRE(table.find(name));
    CHECK(table.find(name)->name == name);
    for (const auto& synonym : category.synonyms) {
      INFO(synonym);
      CHECK(table.find(synonym));
    }
  }
}

TEST_CASE("Every category is something that a room can hold and a person can use") {
  for (const auto& [name, category] : KindTable::built_in().all()) {
    INFO(name);
    CHECK(category.size.minCoeff() > 0.0);
    CHECK(category.size.maxCoeff() <= 6.0);
    CHECK(is_any_of(category, {name}));
    for (const auto& zone : category.zones) CHECK(zone.depth <= 1.5);
    for (const auto& gap : category.gaps) CHECK(gap.low <= gap.high);
    if (category.traits.flat) CHECK(category.size.z() <= 0.1);
  }
}

TEST_CASE("People's words find the kind that they mean") {
  const auto& table = KindTable::built_in();
  const auto found = [&](const char* name) {
    const Kind* category = table.find(name);
    return category ? category->name : std::string("nothing");
  };
  CHECK(found("oak writing desk") == "desk");
  CHECK(found("couch") == "sofa");
  CHECK(found("bookshelves") == "bookshelf");
  CHECK(found("shelves") == "shelf");
  CHECK(found("dining chairs") == "dining chair");
  CHECK(found("red velvet armchair") == "armchair");
  CHECK(found("benches") == "bench");
  CHECK(found("Office Chair") == "office chair");
  CHECK(table.is_a("desk", "table"));
  CHECK(table.is_a("dining chair", "seat"));
}
