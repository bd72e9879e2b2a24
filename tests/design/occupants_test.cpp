#include <algorithm>

#include "brief/prompt.h"
#include "brief/room_kinds.h"
#include "catch.h"
#include "plans.h"
#include "read_brief.h"
#include "roomgen/kinds/kind_table.h"

using namespace roomgen;
using namespace roomgen::brief;

namespace {

int count_of(const Brief& brief, const std::string& kind) {
  int count = 0;
  for (const auto& mention : brief.mentions)
    if (KindTable::built_in().is_a(mention.category, kind)) count += mention.quantity;
  return count;
}

bool is_heard(const Brief& brief, Heard::As as) {
  return std::any_of(brief.heard.begin(), brief.heard.end(),
                     [&](const HeardWords& words) { return words.as == as; });
}

}  // namespace

TEST_CASE("What people are or do asks for nothing by itself") {
  for (const std::string prompt :
       {"a bedroom with a reading corner", "a garage where we brew beer", "a nursery for a baby",
        "an office for a programmer", "a living room for two cats and an old man who plays chess",
        "a study for homework", "a kitchen where a chef bakes"}) {
    INFO(prompt);
    for (const auto& one : test::plan_of(prompt).requirements)
      CHECK(one.kind == Requirement::Kind::room);
  }
}

TEST_CASE("Every clause is said by words of the prompt") {
  for (const std::string prompt :
       {"a classroom for 24 students with a teacher's desk",
        "a bedroom for my twin boys, with a desk for homework", "a canteen for forty people",
        "a bar with stools and a piano, at least 1 m clear all around the piano"}) {
    INFO(prompt);
    const Plan plan = test::plan_of(prompt);
    for (const auto& one : plan.requirements) {
      INFO(one.clause);
      CHECK(std::any_of(plan.heard.begin(), plan.heard.end(), [&](const Heard& heard) {
        return std::find(heard.requirements.begin(), heard.requirements.end(), one.id) !=
               heard.requirements.end();
      }));
    }
  }
}

TEST_CASE("By who a room is for, or what is done there, it is of a kind") {
  const auto kind_of = [](const std::string& prompt) { return read_brief(prompt).type; };
  CHECK(kind_of("a bedroom for a toddler") == "kids room");
  CHECK(kind_of("my daughter's bedroom") == "kids room");
  CHECK(kind_of("a bedroom for our baby") == "nursery");
  CHECK(kind_of("a bedroom for a couple and their baby") == "bedroom");
  CHECK(kind_of("a bedroom with a desk for a child") == "bedroom");
  CHECK(kind_of("a living room for a baby") == "living room");
  CHECK(kind_of("somewhere to do yoga") == "yoga studio");
  CHECK(kind_of("a place where we knit") == "craft room");
}

TEST_CASE("So many things come as there are people") {
  CHECK(count_of(read_brief("a bedroom for my twin boys"), "bed") == 2);
  CHECK(count_of(read_brief("a bedroom for three teenagers"), "bed") == 3);
}

TEST_CASE("A thing for somebody is only that") {
  const Brief chair = read_brief("a hallway with a chair for guests");
  CHECK(chair.mentions.size() == 1);
  CHECK(is_heard(chair, Heard::As::person));
  const Brief lamp = read_brief("a bedroom with a reading lamp");
  CHECK(lamp.mentions.size() == 1);
  CHECK_FALSE(is_heard(lamp, Heard::As::activity));
}

TEST_CASE("Ceilings, lengths behind a name and least numbers are heard") {
  CHECK(read_brief("a bedroom with a ceiling of 2.9 m").height == Approx(2.9));
  CHECK(read_brief("a loft with 4 m high ceilings").height == Approx(4.0));
  CHECK_FALSE(read_brief("a bedroom with a wardrobe of 2.4 m height").height);
  const Brief brief = read_brief("An office with a desk, 180 x 90 cm, and at least five plants.");
  CHECK_FALSE(brief.size);
  REQUIRE(brief.mentions.size() == 2);
  CHECK(brief.mentions[0].size.x() == Approx(1.8));
  CHECK(brief.mentions[0].size.y() == Approx(0.9));
  CHECK(brief.mentions[1].at_least);
  CHECK(brief.mentions[1].quantity == 5);
}

TEST_CASE("A room has what it has for people as often as they need it") {
  for (const auto& [prompt, category, number] :
       {std::tuple{"an office for six people", "desk", 6}, {"an office for six people", "office chair", 6},
        {"a lecture hall for 60 people", "theatre seat", 60}, {"a canteen for 40 people", "table", 10},
        {"a canteen for 40 people", "chair", 40}, {"a dining room for twelve", "dining chair", 12},
        {"a classroom for 24 students", "student desk", 24}, {"a dormitory for eight backpackers", "bunk bed", 4},
        {"a yoga studio for ten", "yoga mat", 10}}) {
    INFO(prompt);
    const Brief brief = read_brief(prompt);
    const auto found = std::find_if(brief.mentions.begin(), brief.mentions.end(),
                                    [&, wanted = std::string(category)](const Mention& mention) { return mention.category == wanted; });
    REQUIRE(found != brief.mentions.end());
    CHECK(found->quantity == number);
    CHECK(found->source == Requirement::Source::person);
    CHECK_FALSE(found->heard.empty());
  }
  // What is named is not brought, and one person needs nothing more than the room has.
  CHECK(things(read_brief("an office for four with two desks")).starts_with("2 desk"));
  CHECK(read_brief("a study for one person").mentions.empty());
}

TEST_CASE("What is somebody's own is no place of the others") {
  const Brief brief = read_brief("a classroom for twelve pupils with a teacher's desk");
  CHECK(things(brief).starts_with("1 desk, 12 student desk, 12 student chair"));
}

TEST_CASE("Rows have as many as the people, or as a row has") {
  CHECK(things(read_brief("a library with six rows of bookshelves")) == "24 bookshelf");
  CHECK(things(read_brief("a classroom for twelve people with three rows of desks")).starts_with("12 student desk"));
}

TEST_CASE("Twins lie in cribs in a nursery, and in beds of their own in a bedroom") {
  CHECK(things(read_brief("a nursery for twins")).find("2 crib") != std::string::npos);
  CHECK(things(read_brief("a nursery for twins")).find("bed") == std::string::npos);
  CHECK(things(read_brief("a bedroom for twins")).find("2 single bed") != std::string::npos);
}

TEST_CASE("A room where people sit has a requirement of seats for those who are named") {
  const auto seats_of = [](const std::string& prompt) {
    for (const auto& one : test::plan_of(prompt).requirements)
      if (one.attribute == "seats for people") return static_cast<int>(one.amount);
    return 0;
  };
  CHECK(seats_of("A dining room for ten.") == 10);
  CHECK(seats_of("A conference room for eight people with an oval table and black chairs.") == 8);
  CHECK(seats_of("A living room for a family of five with a sofa.") == 5);
  CHECK(seats_of("A bedroom for two with an armchair.") == 0);
  CHECK(seats_of("A living room with a sofa.") == 0);
}
