#include "programs.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

const KindTable& kinds() { return KindTable::built_in(); }

bool tagged(const std::string& kind, std::string_view tag) {
  const Kind* found = kinds().by_name(kind);
  REQUIRE(found);
  return has_tag(ProgramVocabulary::built_in(), *found, tag);
}

bool made_by(const std::string& kind, std::string_view factory) {
  const Kind* found = kinds().by_name(kind);
  REQUIRE(found);
  return is_made_by(ProgramVocabulary::built_in(), kinds(), *found, factory);
}

}  // namespace

TEST_CASE("Every kind of the vocabulary exists, and every word covers one") {
  const auto& vocabulary = ProgramVocabulary::built_in();
  REQUIRE(vocabulary.tags.size() >= 25);
  REQUIRE(vocabulary.factories.size() >= 50);
  for (const auto& words : {vocabulary.tags, vocabulary.factories})
    for (const auto& [word, listed] : words) {
      INFO(word);
      CHECK(!listed.empty());
      for (const auto& entry : listed) {
        INFO(entry);
        CHECK(kinds().by_name(entry.starts_with('-') ? entry.substr(1) : entry));
      }
    }
}

TEST_CASE("A factory that has the name of a kind makes that kind") {
  for (const auto& [factory, listed] : ProgramVocabulary::built_in().factories) {
    const Kind* kind = kinds().find(factory);
    INFO(factory);
    if (kind && kind->name == factory) CHECK(made_by(kind->name, factory));
  }
  CHECK_FALSE(made_by("stove", "oven"));
}

TEST_CASE("A tag covers kinds with their descendants, but for those that it takes out") {
  CHECK(tagged("bookshelf", "storage"));
  CHECK(tagged("display cabinet", "storage"));
  CHECK(!tagged("washing machine", "storage"));
  CHECK(!tagged("shop shelf", "storage"));
  CHECK(tagged("dining table", "table"));
  CHECK(!tagged("desk", "table"));
  CHECK(!tagged("executive desk", "table"));
  CHECK(tagged("executive desk", "desk"));
  CHECK(tagged("corner sofa", "lounge-seating"));
  CHECK(!tagged("dining chair", "lounge-seating"));
  CHECK(!tagged("bed", "no such tag"));
}

TEST_CASE("What a room stands on its floor is furniture, rugs and lamps are not") {
  for (const auto* kind : {"bed", "sofa", "dining table", "office chair", "wardrobe", "desk", "toilet", "kitchen island"})
    CHECK(tagged(kind, "furniture"));
  for (const auto* kind : {"rug", "floor lamp", "picture", "ceiling lamp", "book", "wall shelf"})
    CHECK(!tagged(kind, "furniture"));
  for (const auto& [name, kind] : kinds().all()) {
    INFO(name);
    CHECK((!has_tag(ProgramVocabulary::built_in(), kind, "furniture") || kind.mount == Mount::floor));
  }
}

TEST_CASE("Factories are those of the source, and the kinds by their own names") {
  CHECK(made_by("dining chair", "chair"));
  CHECK(!made_by("office chair", "chair"));
  CHECK(made_by("office chair", "office_chair"));
  CHECK(made_by("desk", "simple_desk"));
  CHECK(made_by("towel rack", "bath_hardware"));
  CHECK(made_by("ceiling lamp", "ceiling_light"));
  CHECK(made_by("conference table", "conference_table"));
  CHECK(made_by("conference table", "conference table"));
  CHECK(made_by("console table", "table"));
  CHECK(!made_by("conference table", "no_such_thing"));
}
