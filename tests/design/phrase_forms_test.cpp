#include "catch.h"

#include "read_brief.h"

using namespace roomgen;
using namespace roomgen::brief;

TEST_CASE("looks before one noun are of as many things") {
  for (const char* prompt : {"A room with a black and a white chair.", "A room with a black chair and a white chair."}) {
    INFO(prompt);
    const Brief brief = read_brief(prompt);
    REQUIRE(things(brief) == "1 chair, 1 chair");
    CHECK(brief.mentions[0].looks == std::vector<std::string>{"black"});
    CHECK(brief.mentions[1].looks == std::vector<std::string>{"white"});
  }
  const Brief several = read_brief("A lounge with two red and three blue armchairs.");
  REQUIRE(things(several) == "2 armchair, 3 armchair");
  CHECK(several.mentions[0].looks == std::vector<std::string>{"red"});
  CHECK(things(read_brief("A room with a black and white rug.")) == "1 rug");
}

TEST_CASE("what is round a thing is around it, and a round thing is round") {
  const Brief around = read_brief("A workshop with six stools round a workbench.");
  REQUIRE(things(around) == "6 stool, 1 workbench");
  CHECK(places(around, 0) == "around, workbench");
  const Brief round = read_brief("A dining room with a round table.");
  REQUIRE(round.mentions.size() == 1);
  CHECK(round.mentions[0].demands.empty());
}

TEST_CASE("two things back to back look away from each other and stand at no wall") {
  const Brief brief = read_brief("An office with two desks back to back.");
  REQUIRE(things(brief) == "1 desk, 1 desk");
  CHECK(places(brief, 1) == "behind, desk | face opposite to, desk");
  for (const auto& demand : brief.mentions[0].demands) CHECK(demand.kind != RelationKind::edge);
}

TEST_CASE("each of four tables has four chairs") {
  const Brief brief = read_brief("A dining room with four chairs at each of four tables.");
  REQUIRE(brief.mentions.size() == 2);
  CHECK(brief.mentions[0].quantity == 16);
  CHECK(brief.mentions[1].quantity == 4);
}

TEST_CASE("what each window or corner has is there as often as it is there") {
  const Brief windows = read_brief("A reading room with three windows. Every window has a bench below it.");
  REQUIRE(things(windows) == "3 bench");
  const Brief corners = read_brief("A lounge. Each corner has a plant.");
  REQUIRE(things(corners) == "4 plant");
}

TEST_CASE("who tells of one of a list that it is on the owner, tells nothing of those behind it") {
  const Brief brief = read_brief("A living room with a sideboard with a vase on it, two paintings and a chandelier.");
  REQUIRE(things(brief) == "1 sideboard, 1 vase, 2 picture, 1 chandelier");
  CHECK(places(brief, 1) == "on, sideboard");
  CHECK(brief.mentions[2].demands.empty());
}

TEST_CASE("people have as many computers as desks") {
  CHECK(things(read_brief("An office for four with desks and computers.")) == "4 desk, 4 computer");
  CHECK(things(read_brief("A study with three desks and laptops.")) == "3 desk, 3 laptop");
}

TEST_CASE("what is introduced behind what a thing faces is another thing of the room") {
  const Brief brief = read_brief("A living room with a sofa facing the TV and a bookshelf in the corner.");
  REQUIRE(things(brief) == "1 sofa, 1 tv, 1 bookshelf");
  CHECK(places(brief, 0) == "face to, tv");
  CHECK(places(brief, 1).empty());
  CHECK(places(brief, 2) == "corner");
}

TEST_CASE("colours behind the name of a room are its palette") {
  using Palette = std::vector<std::string>;
  CHECK(read_brief("a bedroom in blue and white").palette == Palette{"blue", "white"});
  CHECK(read_brief("a glamorous dressing room in pink and gold").palette == Palette{"pink", "gold"});
  CHECK(read_brief("a living room in green tones").palette == Palette{"green"});
  CHECK(read_brief("a study in dark wood").palette == Palette{"dark wood"});
  CHECK(read_brief("a bedroom with a blue rug").palette.empty());
}

TEST_CASE("a colour may be unwanted of everything") {
  using Looks = std::vector<std::pair<std::string, std::string>>;
  CHECK(read_brief("a nursery, no pink").excluded_looks == Looks{{"", "pink"}});
  CHECK(read_brief("a bedroom with no red things").excluded_looks == Looks{{"", "red"}});
  CHECK(read_brief("a living room, no glass tables").excluded_looks == Looks{{"table", "glass"}});
}

TEST_CASE("walls may be told to be so") {
  CHECK(read_brief("A cafe. The walls should be sage green.").materials.walls == "sage green walls");
  CHECK(read_brief("A study. The floor must be dark oak.").materials.floor == "dark oak floor");
}

TEST_CASE("a nightstand with a lamp on each side of what came before are two, each with its lamp") {
  const Brief brief = read_brief("A hotel room with a queen bed, a nightstand with a brass lamp on each side.");
  REQUIRE(things(brief) == "1 double bed, 2 nightstand, 2 table lamp");
  CHECK(places(brief, 1).starts_with("next to, double bed"));
  CHECK(places(brief, 2) == "on, nightstand");
  const Brief bench = read_brief(
      "A bedroom with a queen bed, a nightstand with a lamp on each side and a bench at the foot of the bed.");
  REQUIRE(bench.mentions.size() == 4);
  CHECK(places(bench, 3).find("nightstand") == std::string::npos);
}

TEST_CASE("halves and thirds of several are parts of them") {
  const Brief looks = read_brief("A dining room with six chairs. Half of them are black, the rest are grey.");
  REQUIRE(things(looks) == "3 dining chair, 3 dining chair");
  CHECK(looks.mentions[0].looks == std::vector<std::string>{"grey"});
  CHECK(looks.mentions[1].looks == std::vector<std::string>{"black"});
  const Brief halves = read_brief("A dining room with six chairs, half black and half grey.");
  CHECK(things(halves).ends_with("3 dining chair, 3 dining chair"));
  const Brief other = read_brief("A room with six stools at a table, half of them black and the other half grey.");
  CHECK(std::count_if(other.mentions.begin(), other.mentions.end(), [](const Mention& one) { return one.category == "stool" && one.quantity == 3; }) == 2);
  const Brief places_of = read_brief("An office with nine chairs. A third of them face the window.");
  REQUIRE(things(places_of) == "6 office chair, 3 office chair");
  CHECK(places(places_of, 0).empty());
  CHECK(places(places_of, 1) == "face to, window-0");
}

TEST_CASE("a number and a colour stand for some of several") {
  const Brief brief = read_brief("A dining room with six chairs, two red and four white.");
  const auto with = [&](const std::string& look) {
    int number = 0;
    for (const auto& one : brief.mentions)
      if (one.looks == std::vector<std::string>{look}) number += one.quantity;
    return number;
  };
  INFO(things(brief));
  for (const auto& one : brief.mentions) UNSCOPED_INFO(one.description);
  CHECK(with("red") == 2);
  CHECK(with("white") == 4);
}

TEST_CASE("colours that alternate are each on as many") {
  for (const char* prompt : {"A dining room with seven chairs, alternating black and grey.", "A dining room with seven alternating black and grey chairs."}) {
    INFO(prompt);
    const Brief brief = read_brief(prompt);
    for (const auto& one : brief.mentions) UNSCOPED_INFO(one.description << " | " << one.looks.size());
    REQUIRE(things(brief) == "4 dining chair, 3 dining chair");
    CHECK(brief.mentions[0].looks == std::vector<std::string>{"black"});
    CHECK(brief.mentions[1].looks == std::vector<std::string>{"grey"});
  }
}

TEST_CASE("what stands in pairs stands by one of the others") {
  const Brief brief = read_brief("A classroom with twelve desks in pairs.");
  REQUIRE(things(brief) == "6 student desk, 6 student desk");
  CHECK(places(brief, 0).empty());
  CHECK(places(brief, 1) == "next to, student desk");
  REQUIRE(brief.shared_out.size() == 1);
}

TEST_CASE("pairs are as many as are said of them") {
  CHECK(things(read_brief("A hall with six pairs of shoes and a pair of slippers.")) == "6 shoes, 1 slippers");
  CHECK(things(read_brief("A craft room with two pairs of scissors and four pairs of headphones.")) == "2 scissors, 4 headphones");
}

TEST_CASE("a lamp does not stand on the seat that it is for") {
  const Brief brief = read_brief("A reading room with four armchairs, each with its own lamp.");
  REQUIRE(things(brief).starts_with("4 armchair, 4 "));
  CHECK(places(brief, 1) == "near, armchair");
}

TEST_CASE("each has what is named up to what stands between things") {
  const Brief brief = read_brief(
      "An office with six desks, each desk has a monitor and a keyboard, a printer between the desks and the wall, and a plant.");
  CHECK(things(brief).find("6 monitor, 6 keyboard, 1 printer, 1 ") != std::string::npos);
}

TEST_CASE("what is for each person or everyone is there for all of them") {
  const std::string meeting = things(read_brief("A meeting room for twelve with notepads and pens for each person."));
  INFO(meeting);
  CHECK(meeting.find("12 notebook, 12 pen") != std::string::npos);
  const std::string dinner = things(read_brief("A dining room where ten people eat: a table, a plate and a wine glass for everyone."));
  CHECK(dinner.find("10 plate, 10 wine glass") != std::string::npos);
}

TEST_CASE("at a desk one sits, and a monitor is on it") {
  const Brief brief = read_brief("An office with four desks, an office chair and a monitor at each desk.");
  REQUIRE(things(brief) == "4 desk, 4 office chair, 4 monitor");
  CHECK(places(brief, 1).starts_with("around, desk"));
  CHECK(places(brief, 2) == "on, desk");
}

TEST_CASE("all four corners are each corner") {
  const Brief brief = read_brief("A home cinema with speakers in all four corners.");
  REQUIRE(things(brief) == "4 speaker");
  REQUIRE(brief.shared_out.size() == 1);
  CHECK(brief.shared_out[0].place == "corner");
}

TEST_CASE("the share of some along each wall is not doubled twice") {
  CHECK(things(read_brief("A ward with six beds, three along each long wall.")) == "3 hospital bed, 3 hospital bed");
}

TEST_CASE("the left and right are two places") {
  for (const char* prompt : {"A shop with wall shelves on the left and right.", "A shop with wall shelves on the left and right walls."}) {
    INFO(prompt);
    const Brief brief = read_brief(prompt);
    REQUIRE(brief.mentions.size() == 2);
    CHECK(places(brief, 0).ends_with("near, wall-3 | face same as, wall-3"));
    CHECK(places(brief, 1).ends_with("near, wall-1 | face same as, wall-1"));
  }
}

TEST_CASE("columns are side by side") {
  const Brief brief = read_brief("A chapel with eight pews in two columns.");
  REQUIRE(brief.mentions.size() == 1);
  REQUIRE(brief.mentions[0].formation);
  CHECK(brief.mentions[0].formation->columns == 2);
}

TEST_CASE("what is told behind what a thing has is the thing's place where that hangs on it or is a part of it") {
  const Brief vanity = read_brief("A bedroom with a bed and a vanity with an oval mirror across from the bed.");
  REQUIRE(things(vanity) == "1 bed, 1 vanity, 1 round mirror");
  CHECK(places(vanity, 1).starts_with("in front of, bed"));
  CHECK(places(vanity, 2) == "above, vanity");
  const Brief cabinet = read_brief("A clinic with a cabinet with glass doors on the left wall.");
  REQUIRE(cabinet.mentions.size() == 1);
  CHECK(cabinet.openings.empty());
  CHECK(places(cabinet, 0).find("near, wall-3") != std::string::npos);
}

TEST_CASE("its right is that of what it was before") {
  const Brief brief = read_brief("A nook with one armchair by the window, a floor lamp behind it, a side table to its right.");
  REQUIRE(things(brief) == "1 armchair, 1 floor lamp, 1 side table");
  CHECK(places(brief, 2).ends_with(" of, armchair"));
}

TEST_CASE("several are not the one that was named, nor plants orchids") {
  const Brief benches = read_brief("A courtroom. A judge's bench at the front and public benches in four rows at the back.");
  REQUIRE(benches.mentions.size() == 2);
  CHECK(benches.mentions[1].formation);
  const Brief plants = read_brief("A greenhouse with two benches. Tomato plants stand on the left bench and orchids on the right one.");
  CHECK(plants.mentions.size() == 3);
}

TEST_CASE("what is under a bench is on no bench") {
  const Brief brief = read_brief("A greenhouse with two potting benches and terracotta pots under the benches.");
  REQUIRE(brief.mentions.size() == 2);
  CHECK(places(brief, 1) == "under, potting bench");
  CHECK(brief.mentions[1].mount == Mount::floor);
}

TEST_CASE("without an article the last of a pair shares its place") {
  const Brief brief = read_brief("A greenhouse with a watering can by the door, an iron chair and small table at the far end.");
  REQUIRE(brief.mentions.size() == 3);
  CHECK(places(brief, 1) == places(brief, 2));
}

TEST_CASE("what a room is for is no thing of it") {
  CHECK(things(read_brief("A conservatory for painting.")).find("picture") == std::string::npos);
}

TEST_CASE("a denied list ends at what has its own place") {
  const Brief brief = read_brief("A lounge: no rugs, low bookcase under the window.");
  CHECK(brief.excluded == std::vector<std::string>{"rug"});
  CHECK(things(brief) == "1 bookshelf");
}

TEST_CASE("a participle behind a comma and before a noun describes that noun") {
  const Brief brief = read_brief("A parlour with two chairs, framed art all over the left wall and a counter.");
  REQUIRE(brief.mentions.size() == 3);
  CHECK(brief.mentions[1].quantity == 6);
  CHECK(places(brief, 1).find("wall-3") != std::string::npos);
}

TEST_CASE("what is next to a desk is not on it, nor is a television") {
  const Brief perch = read_brief("A study with a desk covered in candles and an hourglass next to the desk.");
  CHECK(places(perch, 2).find("on, ") == std::string::npos);
  const Brief tv = read_brief("A teenager's room with a desk with three monitors and a bean bag in front of the TV.");
  for (std::size_t i = 0; i < tv.mentions.size(); ++i)
    if (tv.mentions[i].category == "tv") CHECK(places(tv, i).find("on, desk") == std::string::npos);
}
