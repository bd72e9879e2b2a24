#include "language/lexicon.h"

#include <ctime>
#include <iostream>

#include "catch.h"

using namespace roomgen::language;

TEST_CASE("The lexicon knows words and their parts of speech") {
  const Lexicon& english = lexicon();
  CHECK(english.size() > 140'000);
  CHECK(english.has("chair", PartOfSpeech::noun));
  CHECK(english.has("dining table", PartOfSpeech::noun));
  CHECK(english.has("cosy", PartOfSpeech::adjective));
  CHECK_FALSE(english.has("cosy", PartOfSpeech::verb));
  CHECK_FALSE(english.has("chairs"));
  CHECK_FALSE(english.has(""));
  CHECK_FALSE(english.has("\xff\xff"));
  CHECK(english.licence().find("Princeton University") != std::string_view::npos);
}

TEST_CASE("Every lemma is found where it is, in order") {
  const Lexicon& english = lexicon();
  for (std::size_t i = 0; i < english.size(); i += 97) {
    REQUIRE(english.has(english.lemma(i)));
    if (i > 0) REQUIRE(english.lemma(i - 1) < english.lemma(i));
  }
}

TEST_CASE("Nouns are in the classes that people put them in") {
  const std::pair<const char*, WordClass> table[] = {
      {"armchair", WordClass::furniture}, {"credenza", WordClass::furniture},
      {"wardrobe", WordClass::furniture}, {"basket", WordClass::container},
      {"jar", WordClass::container},      {"refrigerator", WordClass::appliance},
      {"toaster", WordClass::appliance},  {"jacket", WordClass::garment},
      {"slipper", WordClass::garment},    {"bread", WordClass::food},
      {"coffee", WordClass::food},        {"dog", WordClass::animal},
      {"twin", WordClass::person},        {"baby", WordClass::person},
      {"musician", WordClass::person},    {"yoga", WordClass::activity},
      {"homework", WordClass::activity},  {"morning", WordClass::time},
      {"evening", WordClass::time},       {"joy", WordClass::feeling},
      {"serenity", WordClass::feeling},   {"oak", WordClass::material},
      {"velvet", WordClass::material},    {"crimson", WordClass::color},
      {"turquoise", WordClass::color},    {"violin", WordClass::instrument},
      {"kitchen", WordClass::room},       {"bathroom", WordClass::room},
      {"fern", WordClass::plant},         {"cottage", WordClass::building},
      {"oval", WordClass::shape},         {"bicycle", WordClass::vehicle},
      {"rug", WordClass::furnishing},     {"teddy", WordClass::garment},
      {"elbow", WordClass::body_part},    {"metre", WordClass::quantity}};
  for (const auto& [word, word_class] : table) {
    INFO(word << " " << name_of(word_class));
    CHECK(lexicon().may_be(word, word_class));
  }
  CHECK(lexicon().is("rack", WordClass::artefact));
  CHECK_FALSE(lexicon().is("kitchen", WordClass::artefact));
  CHECK_FALSE(lexicon().is("joy", WordClass::artefact));
  CHECK_FALSE(lexicon().is("dog", WordClass::artefact));
  CHECK_FALSE(lexicon().is("yoga", WordClass::furniture));
  CHECK(lexicon().share("sofa", WordClass::furniture) == 1.0);
}

TEST_CASE("Synonyms and more general words are told") {
  CHECK(lexicon().are_synonyms("sofa", "couch"));
  CHECK(lexicon().are_synonyms("television set", "tv"));
  CHECK_FALSE(lexicon().are_synonyms("sofa", "bed"));
  CHECK(lexicon().steps_up("rocking chair", "chair") == 1);
  CHECK(lexicon().steps_up("armchair", "furniture").value_or(0) > 1);
  CHECK_FALSE(lexicon().steps_up("chair", "armchair"));
  CHECK_FALSE(lexicon().steps_up("chair", "nosuchword"));
}

TEST_CASE("Irregular forms lead to their lemmas and back") {
  CHECK(lexicon().irregular_bases("feet", PartOfSpeech::noun).front() == "foot");
  CHECK(lexicon().irregular_forms("foot", PartOfSpeech::noun).front() == "feet");
  CHECK(lexicon().irregular_bases("feet", PartOfSpeech::verb).empty());
}

TEST_CASE("Every lemma is found, and the time of a look-up is told") {
  const Lexicon& english = lexicon();
  const std::clock_t start = std::clock();
  std::size_t found = 0, asked = 0;
  for (std::size_t i = 0; i < english.size(); i += 7, ++asked)
    found += english.has(english.lemma(i));
  const double seconds =
      static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  std::cout << "lexicon: " << english.size() << " lemmas, " << 1e6 * seconds / asked
            << " us a look-up\n";
  CHECK(found == asked);
}
