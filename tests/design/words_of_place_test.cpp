// Turns by which prompts say how many there are and where they are, three sentences of each.
#include <algorithm>
#include <string>

#include "catch.h"
#include "read_brief.h"

using namespace roomgen;
using namespace roomgen::design;

namespace {

const Mention* find(const Brief& brief, const std::string& category) {
  const auto found = std::find_if(brief.mentions.begin(), brief.mentions.end(),
                                  [&](const Mention& mention) { return mention.category == category; });
  return found == brief.mentions.end() ? nullptr : &*found;
}

int number_of(const std::string& prompt, const std::string& category) {
  const auto brief = read_brief(prompt);
  const Mention* mention = find(brief, category);
  return mention ? mention->quantity : 0;
}

// "on desk": of a thing, the first demand of that kind.
std::string target(const std::string& prompt, const std::string& category, RelationKind kind) {
  const auto brief = read_brief(prompt);
  const Mention* mention = find(brief, category);
  if (!mention) return "no " + category;
  for (const auto& demand : mention->demands)
    if (demand.kind == kind)
      return demand.mention != Demand::none ? brief.mentions[demand.mention].category : demand.part;
  return "nothing";
}

}  // namespace

TEST_CASE("An article is no number of shelves or seats") {
  for (const auto& [prompt, category] : {std::pair{"A study with a desk and a shelf.", "shelf"},
                                         {"A lobby with a seat by the door.", "seat"},
                                         {"A hall with a table and an arm chair.", "armchair"}}) {
    INFO(prompt);
    const auto brief = read_brief(prompt);
    const Mention* mention = find(brief, category);
    REQUIRE(mention);
    CHECK(mention->looks.empty());
  }
  CHECK(find(read_brief("A hall with a three-drawer dresser."), "dresser")->looks == std::vector<std::string>{"three drawer"});
}

TEST_CASE("How far a thing is from another is no size of it") {
  for (const auto& [prompt, category] : {std::pair{"A study with a cabinet 2 m from the wall.", "cabinet"},
                                         {"A hall with a mirror 1.2 m above the floor.", "mirror"},
                                         {"A kitchen with a lamp 0.7 m above the table.", "lamp"}}) {
    INFO(prompt);
    const auto brief = read_brief(prompt);
    REQUIRE(std::any_of(brief.mentions.begin(), brief.mentions.end(),
                        [&](const Mention& mention) { return mention.category.ends_with(category); }));
    for (const auto& mention : brief.mentions) CHECK(mention.lengths.empty());
  }
}

TEST_CASE("One for each is as many as there are of the others") {
  CHECK(number_of("A salon with three barber chairs and one mirror per chair.", "mirror") == 3);
  CHECK(number_of("A classroom with eight desks and one laptop per desk.", "laptop") == 8);
  CHECK(number_of("A ward with four beds and one nightstand per bed.", "nightstand") == 4);
  CHECK(number_of("An attic with three desks with a chair each.", "chair") == 3);
  CHECK(number_of("A lab with two benches with a microscope each.", "microscope") == 2);
  CHECK(number_of("A room with four beds with a blanket each.", "blanket") == 4);
}

TEST_CASE("After what there is not, only that is wanted which is all there is") {
  CHECK(number_of("A bedroom without a desk or a chair, only a wardrobe.", "wardrobe") == 1);
  CHECK(number_of("A studio without a sofa, just a hammock.", "hammock") == 1);
  CHECK(number_of("A hall without a mirror or a rug, only a bench.", "bench") == 1);
}

TEST_CASE("Behind a comma a place is said of what was placed, not of where it is") {
  CHECK(target("A hall with a sofa on a rug, facing the door.", "sofa", RelationKind::face_to).starts_with("door"));
  CHECK(target("A den with a vase on a dresser, next to a clock.", "vase", RelationKind::next_to).find("clock") !=
        std::string::npos);
  CHECK(target("A study with an armchair in the corner, beside a piano.", "armchair", RelationKind::next_to) == "piano");
}

TEST_CASE("What goes with a thing is above or before that thing, not before what it stands at") {
  CHECK(target("A hotel room with a desk opposite the bed, with a mirror above it.", "mirror", RelationKind::above) == "desk");
  CHECK(target("A den with a cabinet beside the sofa, with a picture above it.", "picture", RelationKind::above) == "cabinet");
  CHECK(target("A hall with a bench next to the wardrobe, with a poster above it.", "poster", RelationKind::above) == "bench");
}

TEST_CASE("On top is on what things stand on, not on a chair before it") {
  CHECK(target("A bedroom with a desk, a chair in front and a vase on top.", "vase", RelationKind::on) == "desk");
  CHECK(target("A den with a cabinet, a stool beside it and a radio on top.", "radio", RelationKind::on) == "cabinet");
  CHECK(target("A den with a dresser, an armchair beside it and a clock on top.", "clock", RelationKind::on) == "dresser");
}

TEST_CASE("A word that English has for a thing is not taken apart into a kind") {
  for (const auto& [prompt, kind] : {std::pair{"A bathroom with a toilet and two grab bars.", "bar counter"},
                                     {"A kitchen with a table and an ice chest.", "chest"},
                                     {"A clinic with a desk and a bath chair.", "chair"}}) {
    INFO(prompt);
    CHECK(find(read_brief(prompt), kind) == nullptr);
  }
}

TEST_CASE("Of all of them there is no rest") {
  for (const std::string prompt :
       {"A leather sofa and a glass coffee table occupy the center. Two armchairs flank the sofa, one of them near the "
        "window and the other close to the door.",
        "A lamp. One of them is by the door and the other by the window.",
        "A bed and a desk. The first of them is red, the other one stands by the wall."}) {
    INFO(prompt);
    const auto brief = read_brief(prompt);
    for (const auto& mention : brief.mentions)
      CHECK((mention.part_of == Demand::none || mention.part_of < brief.mentions.size()));
  }
}
