#include <algorithm>
#include <fstream>
#include <set>

#include "catch.h"
#include "language/function_word.h"
#include "roomgen/base/json.h"
#include "base/random.h"
#include "roomgen/design/designer.h"
#include "roomgen/kinds/kind_table.h"

using namespace roomgen;

namespace {

struct Ledger {
  std::string prompt;
  std::vector<Heard> heard;
  std::set<std::string> ids;
  std::vector<Requirement> requirements;
};

void add(const std::vector<Requirement>& requirements, Ledger& ledger) {
  for (const auto& requirement : requirements) {
    CHECK_FALSE(requirement.id.empty());
    CHECK(ledger.ids.insert(requirement.id).second);
    ledger.requirements.push_back(requirement);
  }
}

Ledger ledger_of(const std::string& prompt, std::uint64_t seed = 1) {
  PlanRequest request;
  request.prompt = prompt;
  request.seed = seed;
  Ledger ledger;
  ledger.prompt = prompt;
  const auto designer = make_rule_designer();
  const auto dwelling = plan_dwelling(request, *designer);
  REQUIRE(dwelling);
  if (*dwelling) {
    ledger.heard = (*dwelling)->heard;
    add((*dwelling)->requirements, ledger);
    for (const auto& room : (*dwelling)->rooms) add(room.requirements, ledger);
    return ledger;
  }
  const auto plan = designer->plan(request);
  if (!plan) return ledger;
  ledger.heard = plan->heard;
  add(plan->requirements, ledger);
  return ledger;
}

// Every word that says something stands in exactly one entry, with its own text and known ids.
void check_covered(const Ledger& ledger) {
  INFO(ledger.prompt);
  std::size_t end = 0;
  for (const auto& words : ledger.heard) {
    CHECK(words.begin >= end);
    CHECK(words.end > words.begin);
    CHECK(words.text == ledger.prompt.substr(words.begin, words.end - words.begin));
    for (const auto& id : words.requirements) CHECK(ledger.ids.count(id) == 1);
    end = words.end;
  }
  for (const auto& token : language::tokenize(ledger.prompt)) {
    if (language::is_function_word(token)) continue;
    INFO(token.text);
    CHECK(std::count_if(ledger.heard.begin(), ledger.heard.end(), [&](const Heard& words) {
            return words.begin <= token.span.begin && token.span.end <= words.end;
          }) == 1);
  }
}

// What a word of the prompt was heard as.
std::string heard_as(const Ledger& ledger, std::string_view word) {
  const auto at = ledger.prompt.find(word);
  REQUIRE(at != std::string::npos);
  for (const auto& words : ledger.heard)
    if (words.begin <= at && at < words.end) return std::string(name(words.as));
  return "nothing";
}

const Requirement& asked_by(const Ledger& ledger, std::string_view word, Requirement::Kind kind) {
  const auto at = ledger.prompt.find(word);
  for (const auto& words : ledger.heard)
    if (words.begin <= at && at < words.end)
      for (const auto& requirement : ledger.requirements)
        for (const auto& id : words.requirements)
          if (id == requirement.id && requirement.kind == kind) return requirement;
  static const Requirement nothing;
  FAIL("nothing of that kind is asked by " << word);
  return nothing;
}

}  // namespace

TEST_CASE("Each word of a prompt is heard as what it says") {
  const auto ledger = ledger_of(
      "Create a cosy bedroom, 4 x 5 m, with two oak nightstands next to the bed, a round rug and no "
      "television for two people. The walls are painted sage green. It smells of glorbs.");
  check_covered(ledger);
  CHECK(heard_as(ledger, "bedroom") == "room");
  CHECK(heard_as(ledger, "cosy") == "style");
  CHECK(heard_as(ledger, "4 x 5") == "room");
  CHECK(heard_as(ledger, "two oak") == "count");
  CHECK(heard_as(ledger, "oak") == "attribute");
  CHECK(heard_as(ledger, "nightstands") == "thing");
  CHECK(heard_as(ledger, "television") == "absence");
  CHECK(heard_as(ledger, "sage") == "attribute");
  CHECK(heard_as(ledger, "glorbs") == "not understood");
  CHECK(asked_by(ledger, "nightstands", Requirement::Kind::count).count == 2);
  CHECK(asked_by(ledger, "4 x 5", Requirement::Kind::room).amount == Approx(5.0));
  CHECK(asked_by(ledger, "television", Requirement::Kind::absence).category == "tv");
}

TEST_CASE("Lengths, parts and mounts of things are asked for") {
  const auto ledger = ledger_of(
      "An office with a desk that is 1.6 m wide, a bookcase with drawers and a clock on the wall.");
  check_covered(ledger);
  const auto& width = asked_by(ledger, "1.6 m", Requirement::Kind::attribute);
  CHECK(width.attribute == "width");
  CHECK(width.amount == Approx(1.6));
  CHECK(asked_by(ledger, "drawers", Requirement::Kind::attribute).attribute == "drawers");
}

TEST_CASE("Words of a dwelling lead to the requirements of its rooms") {
  const auto ledger = ledger_of(
      "A two-bedroom apartment with a kitchen. The kitchen has a fridge and the bedrooms have a "
      "double bed each.");
  check_covered(ledger);
  CHECK(asked_by(ledger, "bedroom", Requirement::Kind::room).amount == 2.0);
  CHECK(asked_by(ledger, "fridge", Requirement::Kind::count).category == "refrigerator");
}

TEST_CASE("Whatever words follow each other, none is lost and all ids are known") {
  std::vector<std::string> pool = {"a",     "two",   "the",  "no",    "red",  "big",    "on",
                                   "under", "with",  "and",  ",",     ".",    "next to", "glorb",
                                   "cosy",  "4 x 5 m", "it",  "each", "window", "kitchen", "1.6 m",
                                   "long",  "has",   "for",  "three", "people", "wall",  "corner",
                                   "not",   "oak",   "floor", "\"",   "(",     "\xC3\xA9t\xC3\xA9"};
  for (const auto& [name, kind] : KindTable::built_in().all()) pool.push_back(name);
  Random random(11);
  for (int round = 0; round < 150; ++round) {
    std::string prompt = "A room with a chair";
    const int length = random.integer(1, 30);
    for (int i = 0; i < length; ++i) prompt += " " + random.pick(pool);
    check_covered(ledger_of(prompt, 3));
  }
}

TEST_CASE("What says nothing, or nothing in English, is refused") {
  const auto designer = make_rule_designer();
  const auto plan = [&](const std::string& prompt) {
    PlanRequest request;
    request.prompt = prompt;
    return designer->plan(request);
  };
  for (const char* prompt :
       {"the of and", "asdf qwer", "???", "Ein Schlafzimmer mit einem Bett und zwei Lampen",
        "une chambre avec un lit et deux lampes", "un dormitorio con una cama y dos mesas"}) {
    INFO(prompt);
    const auto refused = plan(prompt);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().kind == Error::Kind::not_understood);
    CHECK(refused.error().message.find("--model") != std::string::npos);
  }
  for (const char* prompt : {"bedroom", "a room", "Der Sessel: a room with an armchair",
                             "a bistro with a la carte menus on the tables", "a cosy one", "a lamp"}) {
    INFO(prompt);
    CHECK(plan(prompt));
  }
}
