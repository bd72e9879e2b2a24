// The table that is compiled into the library.
#include <map>

#include "base/resource.h"
#include "catch.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"
#include "roomgen/kinds/kind_table.h"

using namespace roomgen;

TEST_CASE("The files of data/kinds are read, and the library holds all of them") {
  std::vector<std::string> texts;
  std::vector<KindFile> files;
  for (const auto path : resources("data/kinds/")) {
    const auto text = read_file(std::string(ROOMGEN_SOURCE_DIR "/") + std::string(path));
    REQUIRE(text);
    texts.push_back(*text);
  }
  for (const auto& text : texts) files.push_back({text, "file"});
  const auto table = KindTable::read(files);
  INFO((table ? "" : table.error().message));
  REQUIRE(table);
  CHECK(table->all().size() > 800);
  for (const auto& [name, kind] : table->all()) CHECK(KindTable::built_in().named(name)->name == name);
}

TEST_CASE("Every kind is found by its own name and by its other names") {
  const auto& table = KindTable::built_in();
  for (const auto& [name, kind] : table.all()) {
    INFO(name);
    REQUIRE(table.called(name));
    CHECK(table.called(name)->name == name);
    CHECK(table.find(name)->name == table.planned(kind).name);
    for (const auto& other : kind.names) {
      INFO(other);
      CHECK(table.called(other) == &kind);
    }
    for (const auto& other : kind.loose_names) {
      INFO(other);
      CHECK(table.named(other) == &kind);
      CHECK_FALSE(table.called(other) == &kind);
    }
    for (const auto& other : kind.resembles) {
      INFO(other);
      CHECK(table.named(other) == &kind);
      CHECK(table.only_resembles(other));
      CHECK_FALSE(table.called(other) == &kind);
    }
  }
}

TEST_CASE("No name stands for two kinds") {
  std::map<std::string, std::string> meaning;
  const auto& kinds = KindTable::built_in().all();
  const auto claim = [&](const std::string& name, const std::string& kind) {
    INFO(name << " of " << kind);
    CHECK(meaning.emplace(join(words(name), " "), kind).second);
  };
  for (const auto& [name, kind] : kinds) {
    claim(name, name);
    for (const auto& other : kind.names) claim(other, name);
    for (const auto& other : kind.loose_names) claim(other, name);
    for (const auto& other : kind.resembles) claim(other, name);
  }
}

TEST_CASE("A variant is called by what it is, and needs nothing of its own") {
  for (const auto& [name, kind] : KindTable::built_in().all()) {
    INFO(name);
    CHECK_FALSE(KindTable::built_in().planned(kind).variant);
    if (kind.variant) CHECK_FALSE(kind.parent.empty());
  }
}

TEST_CASE("Every kind is something that a room can hold and a person can use") {
  for (const auto& [name, kind] : KindTable::built_in().all()) {
    INFO(name);
    CHECK(kind.size.minCoeff() > 0.0);
    CHECK(kind.size.maxCoeff() <= 6.0);
    CHECK(is_any_of(kind, {name}));
    for (const auto& zone : kind.zones) CHECK(zone.depth <= 1.5);
    for (const auto& gap : kind.gaps) CHECK(gap.low <= gap.high);
    if (kind.traits.flat) CHECK(kind.size.z() <= 0.1);
  }
}

TEST_CASE("People's words find the kind that they mean") {
  const auto& table = KindTable::built_in();
  const auto found = [&](const char* name) {
    const Kind* kind = table.find(name);
    return kind ? kind->name : std::string("nothing");
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

TEST_CASE("Things face with the side that their user looks to") {
  const auto& table = KindTable::built_in();
  // Their users are at the front and look over them.
  for (const char* name : {"desk", "writing desk", "standing desk", "student desk", "rolltop desk", "drafting table",
                           "workbench", "computer desk", "floating desk", "lab bench", "potting bench",
                           "kitchen counter", "cash register", "typewriter", "sewing machine", "piano", "grand piano",
                           "keyboard piano", "treadmill", "stand-in keyboard instrument"}) {
    INFO(name);
    REQUIRE(table.by_name(name));
    CHECK(table.by_name(name)->faces == Side::back);
  }
  // These look at who is before them, or hold who looks along their front, or have their keeper behind them.
  for (const char* name : {"tv", "monitor", "laptop", "mirror", "standing mirror", "vanity", "styling station", "stove",
                           "refrigerator", "wardrobe", "bookshelf", "sofa", "armchair", "office chair", "bed", "toilet",
                           "reception desk", "bar counter", "service counter", "lectern", "drum kit", "exercise bike",
                           "fireplace", "washing machine", "dining table", "coffee table"}) {
    INFO(name);
    REQUIRE(table.by_name(name));
    CHECK(table.by_name(name)->faces == Side::front);
  }
}
