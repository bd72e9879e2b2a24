// Turns by which prompts say how many there are and where they are, three sentences of each.
#include <algorithm>
#include <string>
#include <tuple>

#include "catch.h"
#include "read_brief.h"

using namespace roomgen;
using namespace roomgen::brief;

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
                                         {"A hall with a mirror 1.2 m above the bench.", "mirror"},
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

namespace {

// Places of every mention of a category, in the order of the brief.
std::string all_places(const std::string& prompt, const std::string& category) {
  const auto brief = read_brief(prompt);
  std::string text;
  for (std::size_t i = 0; i < brief.mentions.size(); ++i)
    if (brief.mentions[i].category == category) text += (text.empty() ? "" : "; ") + places(brief, i);
  return text;
}

}  // namespace

TEST_CASE("The middle of a wall is at that wall, and no middle of the room") {
  for (const auto& [prompt, category, wall] :
       {std::tuple{"A garage with drums in the middle of the back wall.", "drum kit", "wall-2"},
        {"A salon with a sideboard in the middle of the longer wall.", "sideboard", "long-wall"},
        {"A ward with a desk in the centre of the end wall.", "desk", "short-wall"}}) {
    INFO(prompt);
    CHECK(target(prompt, category, RelationKind::center_aligned) == wall);
    CHECK(target(prompt, category, RelationKind::near) == wall);
    CHECK(target(prompt, category, RelationKind::middle) == "nothing");
  }
}

TEST_CASE("Of places that there are two of each has half") {
  CHECK(all_places("A shop with four shelves along both long walls.", "shelf") ==
        "edge | near, long-wall | face same as, long-wall; edge | near, other-long-wall | face same as, other-long-wall");
  CHECK(all_places("An archive with six cabinets on both side walls.", "cabinet").find("wall-3") != std::string::npos);
  CHECK(all_places("A study with two desks at opposite ends of the room.", "desk") == "in part, one-end; in part, other-end");
}

TEST_CASE("At each side of a door or a window stands one") {
  for (const auto& [prompt, category, part] : {std::tuple{"A lounge with an armchair on each side of the window.", "armchair", "window-0"},
                                               {"A hall with a plant on either side of the door.", "plant", "door-0"},
                                               {"An office with a bookshelf on both sides of the window.", "bookshelf", "window-0"}}) {
    INFO(prompt);
    CHECK(number_of(prompt, category) == 2);
    CHECK(target(prompt, category, RelationKind::next_to) == part);
  }
}

TEST_CASE("What an area has stands together") {
  CHECK(target("A salon with a reading corner with an armchair, a floor lamp and a side table.", "floor lamp", RelationKind::near) == "armchair");
  CHECK(target("A den with a music nook with a piano, a stool and a music stand.", "music stand", RelationKind::near) == "piano");
  CHECK(target("An office. In the lounge area a sofa and a plant.", "plant", RelationKind::near) == "sofa");
  // But what is in a corner of the room is no area's.
  CHECK(target("A hall. In the left corner a plant, and a desk.", "desk", RelationKind::near) == "nothing");
}

TEST_CASE("Each has its own, and all have one") {
  CHECK(number_of("A hallway with three stools, each facing its own mirror.", "mirror") == 3);
  CHECK(number_of("A hall with ten round tables, flowers on all tables.", "flowers") == 10);
  CHECK(number_of("A lab with four desks with a monitor and keyboard on each.", "monitor") == 4);
  CHECK(number_of("A bakery with two tables by the window, a pair of chairs each.", "chair") == 4);
}

TEST_CASE("Where seats and what they are at are told of, the place is said of what they are at") {
  const std::string prompt = "A restaurant with a bar with seven stools along the back wall.";
  CHECK(target(prompt, "bar counter", RelationKind::near) == "wall-2");
  CHECK(target(prompt, "stool", RelationKind::edge) == "nothing");
}

TEST_CASE("An age is no number of people, and people who are seated bring no seats") {
  CHECK(read_brief("A bedroom for my 15 yr old son.").people < 2);
  CHECK(number_of("A bedroom for my 15 yr old son.", "single bed") <= 1);
  CHECK(number_of("A dozen chairs for our support group.", "armchair") == 0);
}

TEST_CASE("Nothing of a colour is a denied look") {
  for (const char* prompt : {"A bedroom with nothing purple.", "An office with a desk, nothing pink or dark green.", "A den with no red things."}) {
    INFO(prompt);
    CHECK_FALSE(read_brief(prompt).excluded_looks.empty());
  }
  CHECK(read_brief("An office with a desk, nothing pink or dark green.").excluded_looks.size() == 2);
}

TEST_CASE("A bound behind a denied verb is a size") {
  const auto brief = read_brief("A hall with a wardrobe that is not taller than 1.8 m.");
  const Mention* wardrobe = find(brief, "wardrobe");
  REQUIRE(wardrobe);
  REQUIRE(wardrobe->lengths.size() == 1);
  CHECK(wardrobe->lengths.front().metres == Approx(1.8));
  CHECK(wardrobe->lengths.front().limit == roomgen::language::Measure::Limit::most);
}

TEST_CASE("A colour of two words is one look, and names no sort") {
  for (const auto& [prompt, category, look] : {std::tuple{"A lounge with a navy blue sofa.", "sofa", "navy blue"},
                                               {"A kitchen with two forest green stools.", "stool", "forest green"},
                                               {"A den with a mustard yellow armchair.", "armchair", "mustard yellow"}}) {
    INFO(prompt);
    const auto brief = read_brief(prompt);
    const Mention* mention = find(brief, category);
    REQUIRE(mention);
    CHECK(mention->looks == std::vector<std::string>{look});
    CHECK(mention->naming.empty());
  }
  CHECK(find(read_brief("A den with a leather black armchair."), "armchair")->looks == std::vector<std::string>{"leather", "black"});
}

TEST_CASE("The middle of the window wall is at the window") {
  CHECK(target("A salon with a plant in the middle of the window wall.", "plant", RelationKind::near) == "window-0");
  CHECK(target("A salon with a plant in the middle of the window wall.", "plant", RelationKind::middle) == "nothing");
  CHECK(target("A salon with a plant in the middle of the room.", "plant", RelationKind::middle).empty());
}

TEST_CASE("What follows in the list behind something that is not there is there") {
  for (const auto& [prompt, category] : {std::pair{"A bedroom with a bed without headboard, a paper lantern, a desk.", "desk"},
                                         {"A study, a chair without arms, a bookcase, a globe.", "bookshelf"},
                                         {"A hall, no rug, with a bench without a back, a mirror.", "mirror"}}) {
    INFO(prompt);
    CHECK(number_of(prompt, category) == 1);
  }
  const auto brief = read_brief("A bedroom without a rug, a desk or plants.");
  CHECK(find(brief, "desk") == nullptr);
  CHECK(brief.excluded.size() == 3);
}

TEST_CASE("At each of two walls stand as many") {
  for (const char* prompt : {"A store with four shelving units along each of the long walls.", "A store. Along each long wall stand four shelving units.",
                             "A store with four shelving units against each of the two side walls."}) {
    INFO(prompt);
    int all = 0;
    for (const auto& mention : read_brief(prompt).mentions) all += mention.quantity;
    CHECK(all == 8);
  }
  CHECK(number_of("A store with two shelving units along both long walls.", "shelving unit") == 1);
}

TEST_CASE("Each means what every was said of") {
  for (const auto& [prompt, category] :
       {std::pair{"A hall with six round tables, each table surrounded by four chairs, a vase in the centre of each.", "vase"},
        {"A hall with six round tables, a lamp on every table and a vase on each.", "vase"},
        {"A hall with six round tables, every table with four chairs and a vase on each.", "vase"}}) {
    INFO(prompt);
    CHECK(number_of(prompt, category) == 6);
    CHECK(target(prompt, category, RelationKind::on) == "round table");
  }
}

TEST_CASE("What each is loaded with counts for each") {
  for (const char* prompt : {"A store with four shelving units, each loaded with five storage boxes.",
                             "A store with four shelving units, each stocked with five storage boxes.",
                             "A store with four shelving units, each filled with five storage boxes."}) {
    INFO(prompt);
    CHECK(number_of(prompt, "storage box") == 20);
  }
  const std::string more = "A store with four shelving units, each loaded with five storage boxes, a bench near the door, and one ladder.";
  CHECK(number_of(more, "bench") == 1);
  CHECK(number_of(more, "ladder") == 1);
}

TEST_CASE("Where it is said of what small things are with, a place is not that of the small things") {
  for (const auto& [prompt, category, kind, there] :
       {std::tuple{"A room with a table and a cake with six candles on the table.", "cake", RelationKind::on, "table"},
        {"A workshop with a workbench and a pegboard with tools over the workbench.", "pegboard", RelationKind::above, "workbench"},
        {"A nursery with a changing table with towels on its shelf.", "towel", RelationKind::on, "changing table"}}) {
    INFO(prompt);
    CHECK(target(prompt, category, kind) == there);
  }
}

TEST_CASE("Seats at the ends are at the ends of what was spoken of, not of what comes") {
  const std::string prompt = "A dining room with an oval table: three chairs along each long side and one at either end. A sideboard by the wall.";
  for (const auto& mention : read_brief(prompt).mentions)
    for (const auto& demand : mention.demands)
      if (mention.category == "dining chair") CHECK(read_brief(prompt).mentions.at(demand.mention).category == "round table");
}

TEST_CASE("Opposite the window is across the room from it") {
  for (const auto& [prompt, category] : {std::pair{"A study with a desk opposite the window.", "desk"},
                                         {"A den with a sofa opposite the window.", "sofa"},
                                         {"A hall. Opposite the window stands a piano.", "piano"}}) {
    INFO(prompt);
    CHECK(target(prompt, category, RelationKind::far) == "window-0");
    CHECK(target(prompt, category, RelationKind::near) == "nothing");
  }
}

TEST_CASE("The far corner is one of the back wall's") {
  for (const auto& [prompt, part] : {std::pair{"A gym with a bench in the far corner.", "north-half"},
                                     {"A gym with a bench in the front corner.", "south-half"},
                                     {"A gym with a bench in the back left corner.", "north-west-quarter"}}) {
    INFO(prompt);
    CHECK(target(prompt, "bench", RelationKind::corner) == "");
    CHECK(target(prompt, "bench", RelationKind::in_part) == part);
  }
}

TEST_CASE("Why something is wanted, and who is shown, brings nothing") {
  CHECK(number_of("A nook with books on the floor because I have run out of shelves.", "shelf") == 0);
  CHECK(number_of("A hall with two coats on hooks because the wardrobe broke.", "wardrobe") == 0);
  CHECK(number_of("A boy's room with posters of bands above the bed.", "drum kit") == 0);
}

TEST_CASE("What a desk is covered in lies on it") {
  CHECK(target("A cabin with a table covered in magazines.", "magazine stack", RelationKind::on) == "table");
  CHECK(target("A cabin with a table loaded with books.", "book", RelationKind::on) == "table");
  CHECK(target("A cabin with a table littered with bottles.", "bottle", RelationKind::on) == "table");
}
