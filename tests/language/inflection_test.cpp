#include "language/inflection.h"

#include <set>

#include "catch.h"
#include "language/lexicon.h"

using namespace roomgen::language;

TEST_CASE("Nouns become singular") {
  const std::pair<const char*, const char*> table[] = {
      {"chairs", "chair"},     {"shelves", "shelf"},    {"bookshelves", "bookshelf"},
      {"boxes", "box"},        {"benches", "bench"},    {"couches", "couch"},
      {"glasses", "glass"},    {"vases", "vase"},       {"stoves", "stove"},
      {"knives", "knife"},     {"sheaves", "sheaf"},    {"berries", "berry"},
      {"movies", "movie"},     {"cookies", "cookie"},   {"mattresses", "mattress"},
      {"buses", "bus"},        {"children", "child"},   {"feet", "foot"},
      {"mice", "mouse"},       {"menus", "menu"},       {"pianos", "piano"},
      {"tomatoes", "tomato"},  {"shoes", "shoe"},       {"canvases", "canvas"},
      {"canvas", "canvas"},    {"bus", "bus"},          {"glass", "glass"},
      {"lens", "lens"},        {"gas", "gas"},          {"chess", "chess"},
      {"tennis", "tennis"},    {"series", "series"},    {"dining chairs", "dining chair"},
      {"sofas", "sofa"},       {"loaves", "loaf"},      {"nightstands", "nightstand"},
      {"worktops", "worktop"}, {"beanbags", "beanbag"}, {"pouffes", "pouffe"},
      {"settees", "settee"},   {"curtains", "curtain"}, {"blouses", "blouse"},
      {"wineries", "winery"},  {"foobars", "foobar"},   {"zorches", "zorch"},
      {"women", "woman"}};
  for (const auto& [many, one] : table) CHECK(singular(many) == one);
}

TEST_CASE("Nouns become plural") {
  const std::pair<const char*, const char*> table[] = {
      {"chair", "chairs"},  {"shelf", "shelves"},      {"box", "boxes"},
      {"bench", "benches"}, {"child", "children"},     {"foot", "feet"},
      {"mouse", "mice"},    {"knife", "knives"},       {"berry", "berries"},
      {"toy", "toys"},      {"bookcase", "bookcases"}, {"coffee table", "coffee tables"},
      {"glass", "glasses"}, {"woman", "women"}};
  for (const auto& [one, many] : table) {
    CHECK(plural(one) == many);
    CHECK(is_plural(many));
    CHECK_FALSE(is_plural(one));
  }
}

TEST_CASE("The singular of the plural is the noun") {
  std::size_t asked = 0, kept = 0;
  for (std::size_t i = 0; i < lexicon().size(); ++i) {
    const std::string noun(lexicon().lemma(i));
    const auto senses = lexicon().senses(noun, PartOfSpeech::noun);
    if (noun.find_first_not_of("abcdefghijklmnopqrstuvwxyz") != std::string::npos ||
        noun.size() < 3)
      continue;
    // Nouns that are plurals themselves have no plural.
    if (senses.empty() || is_plural(noun)) continue;
    ++asked;
    if (singular(plural(noun)) == noun)
      ++kept;
    else
      UNSCOPED_INFO(noun << " " << plural(noun) << " " << singular(plural(noun)));
  }
  UNSCOPED_INFO(kept << " of " << asked);
  CHECK(asked > 30'000);
  CHECK(kept >= 0.995 * asked);
}

TEST_CASE("Verbs have a base and a form") {
  const auto check = [](const char* word, const char* base, VerbForm form) {
    INFO(word);
    const auto found = verb(word);
    REQUIRE(found);
    CHECK(found->base == base);
    CHECK(found->form == form);
  };
  check("place", "place", VerbForm::base);
  check("stands", "stand", VerbForm::third_person);
  check("placed", "place", VerbForm::past);
  check("standing", "stand", VerbForm::gerund);
  check("fitted", "fit", VerbForm::past);
  check("carries", "carry", VerbForm::third_person);
  check("hung", "hang", VerbForm::past);
  check("has", "have", VerbForm::third_person);
  check("sitting", "sit", VerbForm::gerund);
  CHECK_FALSE(verb("sofa"));
}

TEST_CASE("Adjectives have a positive") {
  CHECK(positive("taller") == "tall");
  CHECK(positive("biggest") == "big");
  CHECK(positive("cosier") == "cosy");
  CHECK(positive("larger") == "large");
  CHECK_FALSE(positive("tall"));
}
