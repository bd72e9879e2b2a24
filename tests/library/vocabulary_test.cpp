#include "base/resource.h"
#include "catch.h"
#include "library/vocabulary.h"

using namespace roomgen;

TEST_CASE("The built-in vocabulary parses") {
  const auto parsed =
      Vocabulary::parse(resource("data/vocabulary.json").value_or(""), "data/vocabulary.json");
  if (!parsed) FAIL(parsed.error().message);
}

TEST_CASE("A phrase names the kind at its end") {
  CHECK(Vocabulary::built_in().understand("couch").kind == "sofa");
  CHECK(Vocabulary::built_in().understand("two white oak desks with drawers").kind == "desk");
  CHECK(Vocabulary::built_in().understand("a small bedside table").kind == "nightstand");
  CHECK(Vocabulary::built_in().understand("Sofa (three seats)").kind == "sofa");
}

TEST_CASE("What only describes a thing that libraries hold is no part of its name") {
  CHECK(Vocabulary::built_in().understand("round rug").kind == "rug");
  CHECK(Vocabulary::built_in().understand("round rug").name == "rug");
  CHECK(Vocabulary::built_in().understand("small plants").name == "plant");
  CHECK(Vocabulary::built_in().understand("bedside table").name == "bedside table");
}

TEST_CASE("A noun before a kind makes it another thing") {
  for (const auto* phrase : {"chair cushion", "sofa cover", "table runner"}) {
    INFO(phrase);
    CHECK_FALSE(Vocabulary::built_in().understand(phrase).known);
  }
}

TEST_CASE("Phrases without words name nothing") {
  CHECK(Vocabulary::built_in().understand("").kind.empty());
  CHECK(Vocabulary::built_in().understand(" ,;( ").kind.empty());
  CHECK(Vocabulary::built_in().fit("", "") == 0.0);
}

TEST_CASE("Special kinds serve who asks for the general one, not the other way round") {
  CHECK(Vocabulary::built_in().fit("dining chair", "chair") == 1.0);
  CHECK(Vocabulary::built_in().fit("office chair", "chair") < 1.0);
  CHECK(Vocabulary::built_in().fit("chair", "office chair") == 0.0);
  CHECK(Vocabulary::built_in().fit("sofa", "table") == 0.0);
}

TEST_CASE("Kinds that the vocabulary lacks fit themselves only") {
  CHECK(Vocabulary::built_in().understand("a large copper samovar").kind == "samovar");
  CHECK(Vocabulary::built_in().fit("samovar", "samovar") == 1.0);
  CHECK(Vocabulary::built_in().fit("towel rack", "rack") == 0.0);
  CHECK(Vocabulary::built_in().fit("kitchen scale", "bathroom scale") == 0.0);
}

TEST_CASE("A maker's word does not hide what an asset is called") {
  CHECK_FALSE(Vocabulary::built_in().understand("Ektorp sofa").known);
  CHECK(Vocabulary::built_in().understand_name("Ektorp sofa").kind == "sofa");
}

TEST_CASE("A vocabulary reads phrases with the kinds that it is given") {
  const auto kinds = KindTable::parse(R"({"kinds": {"samovar": {"names": ["tea urn"]}}})", "kinds.json");
  REQUIRE(kinds);
  const auto words = Vocabulary::parse(R"({"modifiers": ["copper"]})", "words.json", *kinds);
  REQUIRE(words);
  CHECK(words->understand("copper tea urns").kind == "samovar");
  CHECK_FALSE(words->understand("sofa").known);
}
