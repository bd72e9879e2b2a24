// What a prompt calls its room, known or not.
#include <algorithm>

#include "catch.h"
#include "read_brief.h"
#include "roomgen/base/text.h"
#include "support/contains.h"

using namespace roomgen;
using namespace roomgen::brief;

namespace {

bool notes(const Brief& brief, std::string_view text) {
  return std::any_of(brief.notes.begin(), brief.notes.end(),
                     [&](const std::string& note) { return contains_text(note, text); });
}

}  // namespace

TEST_CASE("Another noun before it makes a hall or an office another kind of room") {
  for (const auto& [prompt, type] :
       {std::pair{"A customs office with a counter and two chairs.", "customs office"},
        {"A fencing hall with four benches.", "fencing hall"},
        {"A cigar lounge with three stools.", "cigar lounge"}}) {
    INFO(prompt);
    const auto brief = read_brief(prompt);
    CHECK(brief.type == type);
    CHECK_FALSE(brief.type_known);
    CHECK(notes(brief, "no kind of room is called"));
  }
  // Whose it is makes no other one.
  CHECK(read_brief("A manager office with a desk.").type == "study");
  CHECK(read_brief("A small hall with a bench.").type == "hallway");
}

TEST_CASE("The room is what it is said to be, though nobody knows such a room") {
  for (const auto& [prompt, type] : {std::pair{"The room is a planetarium. A desk stands in the middle.", "planetarium"},
                                     {"This is a courthouse with two benches and a desk.", "courthouse"},
                                     {"The space is an aviary with a bench and a desk.", "aviary"}}) {
    INFO(prompt);
    const auto brief = read_brief(prompt);
    CHECK(brief.type == type);
    CHECK_FALSE(brief.type_known);
    CHECK(std::none_of(brief.mentions.begin(), brief.mentions.end(),
                       [&](const Mention& mention) { return mention.category == type; }));
  }
}

TEST_CASE("Of several rooms one is made, and the others are told") {
  for (const auto& [prompt, type, other] :
       {std::tuple{"A workshop with a bench, and a nursery for the twins.", "workshop", "nursery"},
        {"One half becomes a library, the other a gym.", "library", "gym"},
        {"A bakery, later a flower shop: two counters.", "bakery", "flower shop"}}) {
    INFO(prompt);
    const auto brief = read_brief(prompt);
    CHECK(brief.type == type);
    CHECK(notes(brief, other));
  }
}
