// "Each", "nothing but", "not there": sentences put together by chance, and what is made of them.
#include <algorithm>
#include <set>
#include <string>

#include "base/random.h"
#include "catch.h"
#include "read_brief.h"
#include "roomgen/design/designer.h"

using namespace roomgen;
using namespace roomgen::brief;

namespace {

Plan plan_of(const std::string& prompt, std::uint64_t seed = 1) {
  PlanRequest request;
  request.prompt = prompt;
  request.seed = seed;
  const auto plan = make_rule_designer()->plan(request);
  REQUIRE(plan);
  return *plan;
}

int number_of(const Plan& plan, const std::string& category) {
  int number = 0;
  for (const auto& item : plan.items)
    if (KindTable::built_in().is_a(item.category, category)) number += item.quantity;
  return number;
}

const Requirement* find(const Plan& plan, Requirement::Kind kind) {
  const auto found = std::find_if(plan.requirements.begin(), plan.requirements.end(),
                                  [&](const Requirement& one) { return one.kind == kind; });
  return found == plan.requirements.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("What each has, there is as often as there are owners") {
  Random random(11);
  const std::vector<std::string> numbers = {"two", "three", "four", "five", "six"}, things = {"lamp", "laptop", "mug", "plant"};
  for (int round = 0; round < 40; ++round) {
    const int index = random.integer(0, 4), count = index + 2;
    const std::string thing = random.pick(things), owners = numbers[static_cast<std::size_t>(index)] + " desks";
    const std::vector<std::string> sentences = {
        "An office with " + owners + ". Each desk has a " + thing + " on it.", "An office with " + owners + ", each with a " + thing + ".",
        "An office with " + owners + " and a " + thing + " on each desk.", "An office with " + owners + ". Every desk holds a " + thing + ".",
        "An office with " + owners + ", one " + thing + " per desk.", "An office with " + owners + " and a " + thing + " for each."};
    const std::string prompt = random.pick(sentences);
    INFO(prompt);
    const Plan plan = plan_of(prompt);
    const Requirement* each = find(plan, Requirement::Kind::each);
    REQUIRE(each);
    CHECK(each->subjects.size() == static_cast<std::size_t>(count));
    CHECK(each->targets.size() == static_cast<std::size_t>(count));
    CHECK(each->count == 1);
    // Each thing is tied to a desk of its own.
    std::set<std::string> owned;
    for (const auto& item : plan.items)
      if (KindTable::built_in().is_a(item.category, each->category) || item.category == each->category)
        for (const auto& relation : item.relations)
          if (relation.target.starts_with("desk")) owned.insert(relation.target);
    CHECK(owned.size() == static_cast<std::size_t>(count));
  }
}

TEST_CASE("Nothing else means that nothing is added") {
  for (const std::string prompt :
       {"A bedroom with a bed and a wardrobe, nothing else.", "A bedroom with a bed and a wardrobe and no other furniture.",
        "A bedroom with nothing but a bed and a wardrobe.", "A bedroom with only a bed and a wardrobe.",
        "A bedroom for a student with a bed and a wardrobe, nothing else."}) {
    INFO(prompt);
    const Plan plan = plan_of(prompt);
    int number = 0;
    for (const auto& item : plan.items) number += item.quantity;
    CHECK(number == 2);
    const Requirement* only = find(plan, Requirement::Kind::only);
    REQUIRE(only);
    CHECK(only->subjects.size() == 2);
    CHECK(only->targets.empty());
  }
}

TEST_CASE("On a desk with nothing but a lamp no other things are planned") {
  for (const std::string prompt : {"A study with a desk. On the desk no more than a lamp and a mug.",
                                   "A study with a desk, nothing on it except a lamp and a mug.",
                                   "A study for an accountant with a desk, on the desk nothing but a lamp and a mug."})
    for (std::uint64_t seed = 1; seed < 4; ++seed) {
      INFO(prompt);
      const Plan plan = plan_of(prompt, seed);
      const Requirement* only = find(plan, Requirement::Kind::only);
      REQUIRE(only);
      CHECK(only->subjects.size() == 2);
      CHECK(only->targets == std::vector<std::string>{"desk-0"});
      int small = 0;
      for (const auto& item : plan.items) small += item.mount == Mount::surface ? item.quantity : 0;
      CHECK(small == 2);
    }
}

TEST_CASE("No other chairs forbids those that are not named, not these") {
  const Plan plan = plan_of("A dining room with a table and two chairs, no other chairs.");
  CHECK(number_of(plan, "chair") == 2);
  CHECK(find(plan, Requirement::Kind::absence) == nullptr);
  REQUIRE(find(plan, Requirement::Kind::only));
  CHECK(KindTable::built_in().is_a("dining chair", find(plan, Requirement::Kind::only)->category));
}

TEST_CASE("Where a thing is not, is a clause, and what it is not near is there") {
  const Plan plan = plan_of("A living room with a sofa and an armchair. The armchair is not next to the sofa.");
  CHECK(number_of(plan, "sofa") >= 1);
  const auto denied = std::find_if(plan.requirements.begin(), plan.requirements.end(),
                                   [](const Requirement& one) { return one.denied; });
  REQUIRE(denied != plan.requirements.end());
  CHECK(denied->category == "armchair");
  CHECK(denied->targets == std::vector<std::string>{"sofa-0"});
}

TEST_CASE("What is done on or with something that is named brings nothing") {
  for (const auto& [prompt, unwanted] : {std::pair{"An office. The intern sleeps on two chairs.", "bed"},
                                         {"A waiting room. An old man plays chess at the table.", "play tent"},
                                         {"A hall. The speaker bangs a hammer.", "speaker"},
                                         {"A cafe with a table and steam on the glass.", "glass"},
                                         {"An office with eight desks in two blocks of four.", "building blocks"},
                                         {"A kitchen with a table and jars along the window sill.", "window sill"},
                                         {"A waiting room with two chairs, umbrella bucket, chessboard.", "umbrella"}}) {
    INFO(prompt);
    const auto brief = read_brief(prompt);
    CHECK(std::none_of(brief.mentions.begin(), brief.mentions.end(),
                       [&](const Mention& mention) { return mention.category == unwanted; }));
  }
}

TEST_CASE("Of as many colours as there are things each has one") {
  const auto brief = read_brief("A laundry for four flatmates: each has one bin (red, blue, green, yellow).");
  int bins = 0;
  std::set<std::string> colours;
  for (const auto& mention : brief.mentions)
    if (mention.category == "trash can") bins += mention.quantity, colours.insert(mention.looks.begin(), mention.looks.end());
  CHECK(bins == 4);
  CHECK(colours == std::set<std::string>{"blue", "green", "red", "yellow"});
  for (const auto& mention : brief.mentions)
    if (mention.category == "trash can") CHECK(mention.looks.size() == 1);
}

TEST_CASE("What people do something with is no thing of the room, what they have is one for each") {
  CHECK(read_brief("A hall. The kids drop scooters and the postman throws letters.").mentions.empty());
  for (const auto& [prompt, number] : {std::pair{"A bedroom where three toddlers nap in their own cots.", 3}, {"A dormitory where five guests sleep in their own beds.", 5}}) {
    int things = 0;
    for (const auto& mention : read_brief(prompt).mentions)
      if (KindTable::built_in().is_any_of(mention.category, {"bed", "crib"})) things += mention.quantity;
    CHECK(things == number);
  }
}

TEST_CASE("Sides told by the door have the door in the front wall") {
  for (std::uint64_t seed = 1; seed < 12; ++seed) {
    const Plan plan = plan_of("A study with a bookcase on the back wall and a desk on the left side.", seed);
    for (const auto& opening : plan.room.openings)
      if (opening.is_entrance()) CHECK(opening.wall == 0);
  }
}
