#include "brief/prompt.h"

#include <algorithm>

#include "brief/room_kinds.h"
#include "catch.h"
#include "read_brief.h"
#include "plans.h"
#include "roomgen/kinds/kind_table.h"

using namespace roomgen;
using namespace roomgen::brief;

namespace {

// "2 armchair, 1 sofa"
std::string excluded(const Brief& brief) {
  std::string text;
  for (const auto& category : brief.excluded) text += (text.empty() ? "" : ", ") + category;
  return text;
}

}  // namespace

TEST_CASE("the kind of room is found by any of its names") {
  struct Case {
    const char* prompt;
    const char* type;
  };
  const Case cases[] = {
      {"a cosy bedroom for two", "bedroom"},
      {"LIVING ROOM", "living room"},
      {"a lounge with a sofa", "living room"},
      {"our eat-in kitchen", "kitchen"},
      {"small restroom", "bathroom"},
      {"a dining area for six", "dining room"},
      {"a sunny terrace", "balcony"},
      {"a kid's room", "kids room"},
      {"a home office", "study"},
      {"a boat house", "boat house"},
      {"a music room with a piano", "music room"},
      {"a brewery with six small tables", "brewery"},
      {"a room with a bed and a wardrobe", "bedroom"},
      {"a room with a bathroom cabinet and a toilet", "bathroom"},
      {"a kitchen table and a sofa in the living room", "living room"},
  };
  for (const auto& one : cases) {
    INFO(one.prompt);
    CHECK(read_brief(one.prompt).type == one.type);
  }
}

TEST_CASE("a room's name that only says what a thing is like names no room") {
  CHECK(read_brief("a theatre poster above the sofa in the living room").type == "living room");
  CHECK(read_brief("a gym bag lies on the bench in the hallway").type == "hallway");
  CHECK(read_brief("a kitchen garden on the balcony").type == "balcony");
  CHECK(read_brief("a doctor's office waiting room").type == "waiting room");
  CHECK(read_brief("a cafe table and two chairs on the balcony").type == "balcony");
}

TEST_CASE("names that mean things as well mean rooms where the prompt begins with them") {
  CHECK(read_brief("a cosy bar with four stools").type == "bar");
  CHECK(read_brief("Design a sauna.").type == "sauna");
  CHECK(read_brief("a pantry").type == "pantry room");
  CHECK(read_brief("a living room with a bar").type == "living room");
  CHECK(read_brief("a kitchen with a pantry").type == "kitchen");
  CHECK(read_brief("a bar, two stools and a lamp").type != "bar");
  CHECK(read_brief("a bar stool and a lamp").type != "bar");
}

TEST_CASE("a room of no name is known by what tells of it") {
  CHECK(read_brief("a bed and a wardrobe").type == "bedroom");
  CHECK(read_brief("two single beds").type == "bedroom");
  CHECK(read_brief("a bunk bed and a wardrobe").type == "kids room");
  CHECK(read_brief("a hospital bed and an iv stand").type == "hospital ward");
  CHECK(read_brief("a crib and a changing table").type == "nursery");
  CHECK(read_brief("a desk and a bookshelf").type == "study");
  CHECK(read_brief("a dental chair and a cabinet").type == "dental surgery");
  CHECK(read_brief("a pew and an altar").type == "chapel");
}

TEST_CASE("sizes are read in metres, feet and areas") {
  const auto size = [](const char* prompt) { return read_brief(prompt).size.value_or(Vec2::Zero()); };
  CHECK(size("a 4x5 m bedroom") == Vec2(4, 5));
  CHECK(size("bedroom, 4.5 by 3.2 metres") == Vec2(4.5, 3.2));
  CHECK(size("kitchen 4 m x 3 m") == Vec2(4, 3));
  CHECK(size("bedroom 350 cm x 4 m").isApprox(Vec2(3.5, 4)));
  CHECK(size("a bedroom of 12 by 15 feet").isApprox(Vec2(12, 15) * 0.3048));
  CHECK(size("a bedroom of 10\u2019 x 12\u2019").isApprox(Vec2(10, 12) * 0.3048));
  CHECK(size("a 3\u00d74 bedroom") == Vec2(3, 4));
  CHECK(read_brief("a bedroom of 20 square metres").area == 20.0);
  CHECK(read_brief("18 m\u00b2 bedroom").area == 18.0);
  CHECK(read_brief("200 sq ft office").area.value_or(0) == Approx(18.58).margin(0.01));
  CHECK_FALSE(read_brief("a bedroom with a 2 x 3 m rug").size);
  CHECK_FALSE(read_brief("a 5000 x 2 m bedroom").size);
}

TEST_CASE("things are read with their numbers") {
  struct Case {
    const char* prompt;
    const char* expected;
  };
  const Case cases[] = {
      {"a bed, two nightstands and a wardrobe", "1 bed, 2 nightstand, 1 wardrobe"},
      {"a pair of armchairs and 6 chairs", "2 armchair, 6 chair"},
      {"a set of four bar stools", "4 bar stool"},
      {"a couple of plants, several books", "2 plant, 3 book"},
      {"plush toys and markers", "2 teddy bear, 2 marker"},
      {"a bedside table lamp", "1 table lamp"},
      {"a glass coffee table", "1 coffee table"},
      {"a three-drawer dresser", "1 dresser"},
      {"a two-seat sofa", "1 loveseat"},
      {"bed desk wardrobe", "1 bed, 1 desk, 1 wardrobe"},
      {"a large, soft, red and white rug", "1 rug"},
      {"a round wooden dining table", "1 round table"},
      {"a desk with drawers", "1 desk"},
      {"a bed. The bed is red. Next to the bed is a lamp.", "1 bed, 1 lamp"},
      {"two nightstands, each with a lamp on it", "2 nightstand, 2 table lamp"},
      {"an armchair and another armchair", "1 armchair, 1 armchair"},
      {"a bed, wardrobe x2, 3x chair, 2 × desk", "1 bed, 2 wardrobe, 3 chair, 2 desk"},
      {"3+ chairs", "3 chair"},
      {"three light stands", "3 studio light"},
      {"a bedroom with a samovar", "1 urn"},
      {"a bedroom with a frobnicator", "1 frobnicator"},
      {"a room with a modern feel and a view", ""},
      {"100 sofas", "100 sofa"},
      {"5000 sofas", "200 sofa"},
      {"a wall-mounted tv", "1 wall tv"},
      {"a dining table surrounded by six chairs", "1 dining table, 6 chair"},
  };
  for (const auto& one : cases) {
    INFO(one.prompt);
    CHECK(things(read_brief(one.prompt)) == one.expected);
  }
}

TEST_CASE("a number beyond what is planned is said") {
  const auto notes = read_brief("a hall with 500 chairs and 20 tables").notes;
  REQUIRE(notes.size() == 1);
  CHECK(notes.front() == "500 of \"chair\" are asked for; at most 200 of one kind are planned");
}

TEST_CASE("nouns that no kind is called by are another word for one, a slip, or get a stand-in") {
  CHECK(things(read_brief("a hall with a fishbowl and two bonnets")) == "1 fish bowl, 2 hat");
  CHECK(things(read_brief("an office with a bokshelf")) == "1 bookshelf");
  CHECK(things(read_brief("a temple with two tubas and an altar")) == "2 tuba, 1 altar");
  CHECK(things(read_brief("a garage with a generator and a catamaran")) == "1 generator, 1 catamaran");
  CHECK(things(read_brief("a bedroom with a wolf, a senator and a sadness")) == "");
  CHECK(things(read_brief("Office. Shredder in the corner.")) == "1 paper shredder");
  CHECK(things(read_brief("a bedroom in oak, linen and verdigris")) == "");
  CHECK(excluded(read_brief("a cafe with no cash register")) == "cash register");
  const Brief brief = read_brief("an office with a bokshelf and a bonnet");
  REQUIRE(brief.notes.size() == 2);
  CHECK(brief.notes[0] == "read \"bokshelf\" as \"bookshelf\"");
  CHECK(brief.notes[1] == "\"bonnet\" is taken for a hat");
}

TEST_CASE("what is said of a stand-in is asked for as of anything") {
  const Brief brief = read_brief("A tuba stands in the corner. A catamaran lies on a red rack next to the tuba.");
  REQUIRE(things(brief) == "1 tuba, 1 catamaran, 1 rack");
  CHECK(places(brief, 0) == "corner");
  CHECK(places(brief, 1).find("next to, tuba") != std::string::npos);
  CHECK(brief.mentions[2].looks == std::vector<std::string>{"red"});
  CHECK_FALSE(brief.mentions[0].known);
  CHECK(brief.mentions[1].size.y() > 2.0);
}

TEST_CASE("what a word means depends on the room") {
  CHECK(things(read_brief("a kitchen with a sink")) == "1 kitchen sink");
  CHECK(things(read_brief("a bathroom with a sink")) == "1 washbasin");
  CHECK(things(read_brief("a balcony with two chairs")) == "2 outdoor chair");
}

TEST_CASE("looks and sizes stay in the description") {
  const auto brief = read_brief("a large blue velvet sofa and a 1.8 m oak desk");
  REQUIRE(brief.mentions.size() == 2);
  CHECK(brief.mentions[0].description == "large blue velvet sofa");
  CHECK(brief.mentions[0].size.x() > KindTable::built_in().get("sofa").size.x());
  CHECK(brief.mentions[1].description == "oak desk");
  CHECK(brief.mentions[1].size.x() == Approx(1.8));
}

TEST_CASE("absences are read") {
  struct Case {
    const char* prompt;
    const char* expected;
  };
  const Case cases[] = {
      {"living room, no TV", "tv"},
      {"a bedroom without a desk", "desk"},
      {"a bedroom with a bed but no rug", "rug"},
      {"no tv, desk or rug", "tv, desk, rug"},
      {"no tv, a desk and a rug", "tv"},
      {"without chairs and without plants", "chair, armchair, plant"},
      {"a bedroom. Do not add a wardrobe.", "wardrobe"},
      {"no tv stand but a tv", "tv stand"},
  };
  for (const auto& one : cases) {
    INFO(one.prompt);
    CHECK(excluded(read_brief(one.prompt)) == one.expected);
  }
  CHECK(read_brief("a bedroom without windows").windows == 0);
  CHECK(read_brief("a bedroom with only a bed").bare);
  CHECK(read_brief("a bed and a desk, nothing else").bare);
}

TEST_CASE("people are counted") {
  CHECK(read_brief("a bedroom for two").people == 2);
  CHECK(read_brief("a dining room for a family of four").people == 4);
  CHECK(read_brief("a bedroom for a couple").people == 2);
  CHECK(read_brief("a table for eight people").people == 8);
  CHECK(read_brief("a dining table that seats six").people == 6);
  CHECK(read_brief("room for two chairs").people == 0);
}

TEST_CASE("plurals without a number are as many as what they are joined to, serve or belong to") {
  struct Case {
    const char* prompt;
    std::size_t mention;
    int number;
  };
  const Case cases[] = {
      {"an office with eight desks and chairs", 1, 8},
      {"a workshop with three benches and lamps", 1, 3},
      {"a classroom with twelve desks with chairs", 1, 12},
      {"a dining room with two tables and chairs", 1, 8},
      {"a dining room with a table and chairs", 1, 4},
      {"an office for four with desks and a sofa", 0, 4},
      {"a study with two sofas, chairs and a desk", 1, 1},
      {"a bedroom with lamps and a bed", 0, 2},
  };
  for (const auto& one : cases) {
    INFO(one.prompt);
    const Brief brief = read_brief(one.prompt);
    REQUIRE(brief.mentions.size() > one.mention);
    CHECK(brief.mentions[one.mention].quantity == one.number);
  }
}

TEST_CASE("what is listed beside a table does not stand on it") {
  for (const char* prompt : {"a den with a coffee table, a television and a chair", "a sofa, a side table, a radio and a rug"}) {
    INFO(prompt);
    const Brief brief = read_brief(prompt);
    for (const auto& mention : brief.mentions)
      CHECK(std::none_of(mention.demands.begin(), mention.demands.end(),
                         [](const Demand& demand) { return demand.kind == RelationKind::on; }));
  }
}

TEST_CASE("placements become demands") {
  struct Case {
    const char* prompt;
    std::size_t mention;
    const char* expected;
  };
  const Case cases[] = {
      {"a desk by the window", 0, "near, window-0"},
      {"a bed against the wall", 0, "edge"},
      {"a bed against the left wall", 0, "edge | near, wall-3 | face same as, wall-3"},
      {"a wardrobe in the corner of the room", 0, "corner"},
      {"a table in the middle of the room", 0, "middle"},
      {"a sofa facing the tv stand", 0, "face to, tv stand"},
      {"a rug under the table", 0, "under, table"},
      {"a lamp on the nightstand", 0, "on, nightstand"},
      {"chairs around the dining table", 0, "around, dining table"},
      {"a sofa across from the fireplace", 0, "in front of, fireplace | face to, fireplace | far, fireplace"},
      {"a plant to the left of the sofa", 0, "right of, sofa"},
      {"a plant between the sofa and the window", 0, "between, sofa | between, window-0"},
      {"a sofa with a coffee table in front of it", 1, "in front of, sofa"},
      {"a bed with a nightstand to its right", 1, "left of, bed"},
      {"The desk is near the door.", 0, "near, door-0"},
      {"Next to the bed stands a lamp.", 1, "next to, bed | side of, bed"},
      {"a painting above the sofa", 0, "above, sofa"},
      {"a chest at the foot of the bed", 0, "in front of, bed | near, bed"},
      {"a chair behind the desk", 0, "around, desk | in front of, desk"},
      {"a sofa on the rug", 1, "under, sofa"},
      {"a sofa and an armchair are against the wall", 0, "edge"},
      {"A desk sits directly under a wide window.", 0, "near, window-0 | in front of, window-0"},
      {"a sofa facing a wall-mounted tv", 0, "face to, wall tv"},
      {"A vase and a candle sit on the desk.", 0, "on, desk"},
      {"A desk holds a laptop, a mug and a lamp.", 1, "on, desk"},
      {"A desk holds a laptop, a mug and a lamp.", 2, "on, desk"},
      {"A desk holds a laptop, a mug and a lamp.", 3, "on, desk"},
      {"A desk holds a laptop, and a rug lies under the bed.", 2, "under, bed"},
      {"On the desk sit a laptop and a mug.", 2, "on, desk"},
      {"A bookshelf displays two vases.", 1, "on, bookshelf"},
      {"a tray with two cups on a table", 1, "on, tray"},
      {"A desk, a laptop on it and a mouse to the right of the laptop.", 2,
       "on, desk | left of, laptop"},
      {"A media console stands by the wall. A plant is next to the console.", 1,
       "next to, tv stand | side of, tv stand"},
      {"A table with three stools holds a vase.", 2, "on, table"},
      {"a desk and a bookshelf side by side", 1, "next to, desk | side of, desk"},
      {"a desk with a chair nearby", 1, "near, desk"},
      {"A lamp stands on the desk, and a vase and a mug sit on the shelf.", 0, "on, desk"},
      {"A lamp stands on the desk, and a vase and a mug sit on the shelf.", 2, "on, shelf"},
      {"Two bookshelves hold a vase and a clock.", 1, "on, bookshelf"},
      {"A side table next to a sofa holds a vase.", 2, "on, side table"},
      {"A sideboard holds a vase filled with flowers and a fruit bowl.", 3, "on, sideboard"},
      {"A desk and a shelf. A cup is on the desk surface.", 2, "on, desk"},
      // What stands for the whole: its edge, its lid, its cushion.
      {"A rubber duck sits on the edge of the bathtub.", 0, "on, bathtub"},
      {"a teddy bear on the lid of a low toy box", 0, "on, toy box"},
      {"A vase rests at one end of the sideboard.", 0, "on, sideboard"},
      {"A sofa. A remote control lies on the sofa cushion.", 1, "on, sofa"},
      {"A table, a console table, and a bowl on the tabletop.", 2, "on, table"},
      {"A desk faces the wall, with a laptop at its center.", 1, "on, desk"},
      // Inside: the books are not on the basket's rim.
      {"a basket filled with two books", 1, "on, basket | inside, basket"},
      {"two books inside the bookshelf", 0, "on, bookshelf | inside, bookshelf"},
      {"A shelf holds a neatly folded towel.", 1, "on, shelf"},
      // Who is meant: the workbench, the furniture under a small thing, the one with the board.
      {"A workbench and a stool. A lamp stands on the bench.", 2, "on, workbench"},
      {"A desk holds a tray. A stool stands next to the tray.", 2, "next to, desk | side of, desk"},
      {"A board game with a cup on top lies on a desk.", 0, "on, desk"},
      {"A stool faces the workbench, where a computer stands on top.", 2, "on, workbench"},
      {"A sideboard is lit by a table lamp.", 1, "on, sideboard"},
      {"A monitor is on the desk, with a keyboard and a mouse arranged in front.", 3,
       "on, desk | in front of, monitor"},
      {"A table is surrounded by two chairs. Above hangs a lantern.", 2, "above, table"},
      {"A desk with a swivel chair in front of it.", 1, "in front of, desk | around, desk"},
      {"A dining table with two benches", 1, "around, dining table"},
      {"A kitchen island stands under the window, where a kettle boils.", 1, "on, kitchen island"},
      // A place, a comma, and what is at another place.
      {"The bathtub is under the window, the toilet beside it, a basket next to the toilet.", 1,
       "next to, bathtub | side of, bathtub"},
      {"A laptop sits on the desk, a filing cabinet under it, and a chair in front of it.", 2, "under, desk"},
      {"A laptop sits on the desk, a filing cabinet under it, and a chair in front of it.", 3,
       "in front of, desk | around, desk"},
      // Several that one word stands for.
      {"A sofa faces a tv stand, and a rug lies between them.", 2, "between, sofa | between, tv stand"},
      {"A sofa and an armchair stand by the window with a side table between them.", 2,
       "between, sofa | between, armchair"},
      {"A bedroom with two beds, a nightstand between them, and a wardrobe.", 1, "between, bed"},
      {"A sofa and an armchair, both facing the fireplace.", 1, "face to, fireplace"},
      {"Six desks, each with a laptop, all facing the whiteboard on the front wall.", 0, "used facing, whiteboard"},
      // Who is meant: what the clause before was about.
      {"The TV hangs above a low sideboard, the sofa faces it.", 2, "face to, wall tv"},
      // A place before its things.
      {"Between the sofa and the fireplace lies a rug.", 2, "between, sofa | between, fireplace"},
      {"A desk stands by the wall, on which there is a lamp.", 1, "on, desk"},
      {"On the left as you come in there is a coat rack.", 0, "in part, west-half"},
      {"A plant stands in the near left corner.", 0, "corner | in part, south-west-quarter"},
      {"A desk and a workbench with two stools.", 2, "around, workbench | in front of, workbench"},
  };
  for (const auto& one : cases) {
    INFO(one.prompt);
    const auto brief = read_brief(one.prompt);
    REQUIRE(brief.mentions.size() > one.mention);
    CHECK(places(brief, one.mention) == one.expected);
  }
}

TEST_CASE("what is built in or said again is no further thing, and what is further is one") {
  CHECK(things(read_brief("a bathroom vanity with an integrated sink and a built-in shelf")) ==
        "1 bathroom vanity");
  CHECK(things(read_brief("a plant stands near the door")) == "1 plant");
  CHECK(things(read_brief("A stool holds a towel. A cabinet holds extra towels.")) ==
        "1 stool, 1 towel, 1 cabinet, 2 towel");
  CHECK(things(read_brief("a wardrobe with two wicker baskets in total")) == "1 wardrobe, 2 basket");
}

TEST_CASE("how things are put up is heard in and behind their names") {
  const auto mount = [](const std::string& prompt, std::size_t mention) {
    return read_brief(prompt).mentions.at(mention).mount;
  };
  CHECK(mount("a sofa facing a wall-mounted 65-inch flat-screen TV", 1) == Mount::wall);
  CHECK(mount("a projector hangs from the ceiling", 0) == Mount::ceiling);
  CHECK(mount("a table and a work lamp that hangs above the table", 1) == Mount::ceiling);
  CHECK(mount("a painting hangs above the sofa", 0) == Mount::wall);
  CHECK(mount("two candles on the floor", 0) == Mount::floor);
  CHECK(mount("A bookshelf holds two books and a framed photo.", 2) == Mount::surface);
}

TEST_CASE("seats on the long sides of a table are before and behind it in turn") {
  const auto plan = roomgen::test::plan_of("A dining table with six chairs, three on each long side.");
  int before = 0, behind = 0;
  for (const auto& item : plan.items)
    for (const auto& relation : item.relations) {
      before += relation.kind == RelationKind::in_front_of ? item.quantity : 0;
      behind += relation.kind == RelationKind::behind ? item.quantity : 0;
    }
  CHECK(before == 3);
  CHECK(behind == 3);
}

TEST_CASE("what carries many things is larger") {
  const auto tray = [](const std::string& prompt) {
    const auto brief = read_brief(prompt);
    return brief.mentions.front().size.head<2>().prod();
  };
  CHECK(tray("a tray with six mugs") > 1.2 * tray("a tray with one mug"));
  CHECK(tray("a bookshelf with six mugs") == tray("a bookshelf with one mug"));
}

TEST_CASE("of two numbers of the same things the first is built, and the other is told") {
  const auto brief = read_brief("exactly two chairs and exactly three chairs");
  REQUIRE(brief.mentions.size() == 2);
  CHECK_FALSE(brief.mentions[0].contradicts);
  CHECK(brief.mentions[1].contradicts);
  CHECK_FALSE(brief.notes.empty());
  const auto apart = read_brief("two chairs by the window and three chairs by the door");
  CHECK_FALSE(apart.mentions[1].contradicts);
}

TEST_CASE("a thing on each of several makes as many") {
  const auto brief = read_brief("a sofa, two side tables and a lamp on each side table");
  REQUIRE(brief.mentions.size() == 3);
  CHECK(brief.mentions[2].quantity == 2);
  CHECK(places(brief, 2) == "on, side table");
}

TEST_CASE("a thing on each side makes two") {
  const auto brief = read_brief("a bed with a nightstand on each side");
  CHECK(things(brief) == "1 bed, 2 nightstand");
  CHECK(brief.mentions[1].demands.front().flank);
}

TEST_CASE("so many on each side are as many again, and what stands at the end is one more") {
  const auto count_of = [](const char* prompt, std::size_t mention) {
    const auto brief = read_brief(prompt);
    return brief.mentions.size() > mention ? brief.mentions[mention].quantity : 0;
  };
  CHECK(count_of("a long table with five chairs on each side", 1) == 10);
  CHECK(count_of("a table with eight chairs on either side", 1) == 16);
  CHECK(count_of("a table with two chairs on each side", 1) == 4);
  CHECK(count_of("a bed with two nightstands on either side", 1) == 2);
  CHECK(count_of("a table with ten chairs, five on each side", 1) == 10);
  CHECK(count_of("a long table with five chairs on each side and one at the head", 2) == 1);
}

TEST_CASE("first, second and last say which of several things is meant") {
  const auto which = [](const char* prompt, std::size_t mention) {
    return read_brief(prompt).mentions.at(mention).demands.at(0).nth;
  };
  CHECK(which("Three benches. On the second bench there is a tray.", 1) == 1);
  CHECK(which("Two shelves hang on the wall. A clock stands on the first shelf.", 1) == 0);
  CHECK(which("Four filing cabinets with a printer on top of the last one.", 1) == 3);
  CHECK(which("Two beds. A lamp stands next to the bed.", 1) == -1);
}

TEST_CASE("two kinds of things that flank one are one each, on either side") {
  CHECK(things(read_brief("a bed flanked by a plant and a lamp")).find("2 ") == std::string::npos);
  const auto plan = test::plan_of("a bedroom with a bed flanked by a plant and a nightstand");
  int left = 0, right = 0;
  for (const auto& item : plan.items)
    for (const auto& relation : item.relations) {
      left += relation.kind == RelationKind::left_of;
      right += relation.kind == RelationKind::right_of;
    }
  CHECK(left == 1);
  CHECK(right == 1);
}

TEST_CASE("what is in a thing is no thing, and pairs of one piece are one") {
  CHECK(things(read_brief("a shelf with a bowl of soup")) == things(read_brief("a shelf with a bowl")));
  CHECK(read_brief("a desk with headphones").mentions.back().quantity == 1);
  CHECK(read_brief("a desk with a pair of headphones").mentions.back().quantity == 1);
  CHECK(read_brief("a room with a pair of armchairs").mentions.back().quantity == 2);
}

TEST_CASE("words of style are heard where they speak of the room") {
  const auto has = [](const Brief& brief, const std::string& style) {
    return std::find(brief.styles.begin(), brief.styles.end(), style) != brief.styles.end();
  };
  CHECK(has(read_brief("a cosy, modern bedroom"), "modern"));
  CHECK(has(read_brief("a bedroom in a rustic style"), "rustic"));
  CHECK_FALSE(has(read_brief("a bedroom with a modern lamp"), "modern"));
}

TEST_CASE("what floor, walls and ceiling are covered with") {
  const auto materials = [](const std::string& prompt) {
    const RoomMaterials m = read_brief(prompt).materials;
    return m.floor + "|" + m.walls + "|" + m.ceiling + "|" + finish_named(m, accent_name);
  };
  CHECK(materials("A bedroom with an oak floor and sage walls") == "oak floor|sage walls||");
  CHECK(materials("bedroom, dark hardwood floors, white brick walls, a bed") ==
        "dark hardwood floors|white brick walls||");
  CHECK(materials("A kitchen with a black and white checkerboard floor.") ==
        "black and white checkerboard floor|||");
  CHECK(materials("The walls are painted in pale blue and the floor is made of walnut.") ==
        "walnut floor|pale blue walls||");
  CHECK(materials("a lounge with striped wallpaper and a wooden ceiling") ==
        "|striped wallpaper|wooden ceiling|");
  CHECK(materials("a wood-panelled study with a desk") == "|wood panelled||");
  CHECK(materials("a living room with a navy accent wall") == "|||navy accent wall");
  CHECK(materials("a loft with exposed brick, polished concrete floors") ==
        "polished concrete floors|exposed brick||");
  CHECK(materials("a tiled bathroom with a bath") == "tiled|||");
  CHECK(materials("a bathroom with white subway tiles") == "|white subway tiles||");
}

TEST_CASE("things of those materials are no floors and walls") {
  for (const std::string prompt :
       {"a bedroom with a white wall clock and an oak floor lamp", "a black ceiling lamp over the bed",
        "a bedroom with a red brick fireplace", "a room with a wooden floor cushion",
        "an office with an oak desk and a white wall shelf", "a bedroom with no carpet",
        "a study with walls and white bookshelves", "a room with wall with white shelves"}) {
    INFO(prompt);
    const RoomMaterials m = read_brief(prompt).materials;
    CHECK((m.floor + m.walls + m.ceiling + finish_named(m, accent_name)).empty());
  }
  CHECK(things(read_brief("a bedroom with a bed, oak floors, a striped wallpaper and a wardrobe")) ==
        "1 bed, 1 wardrobe");
  CHECK(things(read_brief("a bedroom with a ceiling light, white walls and a bed")) ==
        things(read_brief("a bedroom with a ceiling light and a bed")));
}

TEST_CASE("things still stand where the wall is spoken of") {
  const Brief brief = read_brief("a bedroom with a picture on the white wall");
  CHECK(finish_named(brief.materials, accent_name) == "white wall");
  REQUIRE(brief.mentions.size() == 1);
  CHECK(places(brief, 0) == places(read_brief("a bedroom with a picture on the wall"), 0));
}

TEST_CASE("each and every give each of the owners as many as are said of one") {
  const std::pair<const char*, const char*> cases[] = {
      {"an office with three desks, each with a chair and two lamps", "3 desk, 3 office chair, 6 table lamp"},
      {"we need five tables, each with four chairs, plus a lectern", "5 table, 20 chair, 1 lectern"},
      {"6 desks each with an office chair, 4 potted plants, 2 printers", "6 desk, 6 office chair, 4 plant, 2 printer"},
      {"a hall with three tables with two chairs at each", "3 table, 6 chair"},
      {"a workshop with four stools; a bucket stands beside each stool", "4 stool, 4 bucket"},
      {"a canteen with four tables and six chairs at each table", "4 table, 24 chair"},
      {"a classroom with ten desks, one chair per desk", "10 student desk, 10 student chair"},
      {"a bedroom with two nightstands, each holding a lamp", "2 nightstand, 2 table lamp"},
      {"a hall with two rows of five chairs", "10 chair"},
      {"three benches. Every bench has a vase.", "3 bench, 3 vase"},
      {"a lamp stands on the desk and each drawer is closed", "1 table lamp, 1 desk"},
  };
  for (const auto& [prompt, expected] : cases) {
    INFO(prompt);
    CHECK(things(read_brief(prompt)) == expected);
  }
}

TEST_CASE("between takes two things, or two of a kind") {
  CHECK(places(read_brief("a lamp between the bed and the desk"), 0) == "between, bed | between, desk");
  const auto beds = read_brief("a bedroom with two beds and a nightstand between them");
  CHECK(places(beds, 1) == "between, bed");
  CHECK(places(read_brief("a plant between the windows"), 0) == "between, window-0 | between, window-1");
  CHECK(places(read_brief("a bed and a rug between the bed and the wall"), 1).find("between") ==
        std::string::npos);
}

TEST_CASE("parts of the room are places") {
  const std::pair<const char*, const char*> cases[] = {
      {"a desk in the northern half of the room", "in part, north-half"},
      {"a desk at the south end", "in part, south-third"},
      {"a desk in the left third", "in part, west-third"},
      {"a desk in the middle third of the hall", "in part, middle-third"},
      {"a desk at the back", "in part, north-half"},
      {"a desk in the south-west corner", "corner | in part, south-west-quarter"},
      {"a desk in the back left corner of the room", "corner | in part, north-west-quarter"},
      {"a study. Western half: a desk.", "in part, west-half"},
      {"a study. North wall: a desk.", "edge | near, wall-2 | face same as, wall-2"},
  };
  for (const auto& [prompt, expected] : cases) {
    INFO(prompt);
    CHECK(places(read_brief(prompt), 0) == expected);
  }
}

TEST_CASE("a heading says where what follows is, unless it has a place of its own") {
  const auto brief = read_brief("Eastern half: a table with a vase on it; a sofa by the window. A desk.");
  REQUIRE(things(brief) == "1 table, 1 vase, 1 sofa, 1 desk");
  CHECK(places(brief, 0) == "in part, east-half");
  CHECK(places(brief, 1) == "on, table");
  CHECK(places(brief, 2) == "near, window-0 | in part, east-half");
  CHECK(places(brief, 3).empty());
}

TEST_CASE("the sides of the room may be said one by one, before any thing") {
  const auto brief = read_brief("A garage, 9 m deep, 6 m wide, 3.4 m high, with a workbench 2 m wide.");
  REQUIRE(brief.size);
  CHECK(brief.size->x() == Approx(6));
  CHECK(brief.size->y() == Approx(9));
  CHECK(brief.height == Approx(3.4));
  CHECK_FALSE(read_brief("a study with a desk 2 m wide and a shelf 2 m deep").size);
  CHECK_FALSE(read_brief("a study with a 2 m wide desk").size);
}

TEST_CASE("what a thing is in may be its material or colour") {
  const auto look = [](const char* prompt) { return read_brief(prompt).mentions.at(0).description; };
  CHECK(look("a wardrobe in pale ash") == "pale ash wardrobe");
  CHECK(look("a stool in black vinyl") == "black vinyl stool");
  CHECK(look("a trolley in aluminium") == "aluminium trolley");
  CHECK(look("a wardrobe in the corner") == "wardrobe");
  CHECK(look("a chair in use") == "chair");
}

TEST_CASE("the entrance is a door to what is near it, and a room to what is in it") {
  CHECK(places(read_brief("a shop with a counter facing the entrance"), 0) == "used facing, door-0");
  CHECK(places(read_brief("a shop with a coat stand next to the entrance"), 0) == "next to, door-0");
  CHECK(places(read_brief("a bench in the entrance"), 0).find("door") == std::string::npos);
}

TEST_CASE("on each side comes before what each carries") {
  CHECK(things(read_brief("A nightstand stands on each side of the bed, each carrying a lamp.")) ==
        "2 nightstand, 1 bed, 2 table lamp");
}

TEST_CASE("what is added behind a thing between marks is said of it") {
  const auto racks = read_brief("Racks, 2 m tall, anthracite, along the wall and a desk (blue).").mentions;
  REQUIRE(racks.size() == 2);
  REQUIRE(racks[0].lengths.size() == 1);
  CHECK(racks[0].lengths[0].side == "height");
  CHECK(racks[0].lengths[0].metres == Catch::Detail::Approx(2.0));
  CHECK(racks[0].looks == std::vector<std::string>{"anthracite"});
  CHECK(racks[1].looks == std::vector<std::string>{"blue"});
  CHECK(things(read_brief("Office chairs: ten, black.")) == "10 office chair");
  CHECK(things(read_brief("Filing cabinets, four in number, and a desk")) == "4 filing cabinet, 1 desk");
  // What is no addition as a whole is none.
  CHECK(read_brief("A desk, white lies told on Sundays.").mentions[0].looks.empty());
  CHECK(things(read_brief("A desk. Ten.")) == "1 desk");
}

TEST_CASE("lengths and numbers may be bounded") {
  using Limit = language::Measure::Limit;
  const auto wardrobe = read_brief("a bedroom with a wardrobe no taller than 1.8 m").mentions.at(0);
  REQUIRE(wardrobe.lengths.size() == 1);
  CHECK(wardrobe.lengths[0].side == "height");
  CHECK(wardrobe.lengths[0].limit == Limit::most);
  CHECK(wardrobe.size.z() == Catch::Detail::Approx(1.8));
  const auto table = read_brief("a table at least 2 m long").mentions.at(0);
  REQUIRE(table.lengths.size() == 1);
  CHECK(table.lengths[0].limit == Limit::least);
  CHECK(table.size.x() >= 2.0);
  CHECK(read_brief("no more than three chairs and a table").mentions.at(0).at_most);
  CHECK(read_brief("at least three chairs and a table").mentions.at(0).at_least);
}

TEST_CASE("several things may stand in rows") {
  const auto formation = [](const std::string& prompt) {
    const Brief brief = read_brief(prompt);
    for (const auto& mention : brief.mentions)
      if (mention.formation)
        return std::to_string(mention.quantity) + " " + mention.category + " " +
               std::to_string(mention.formation->rows) + "x" +
               std::to_string(mention.formation->columns);
    return std::string("none");
  };
  CHECK(formation("Eight desks in two rows of four and a blackboard") == "8 desk 2x4");
  CHECK(formation("three rows of five chairs facing a screen") == "15 chair 3x5");
  CHECK(formation("six lockers in a row along the wall, a bench") == "6 locker 1x0");
  CHECK(formation("Yoga mats: twenty-four, four rows of six") == "24 yoga mat 4x6");
  CHECK(formation("nine stools in a 3 by 3 grid") == "9 stool 3x3");
  // Small things, and one alone, are not put in rows.
  CHECK(formation("a desk with a row of books") == "none");
  CHECK(formation("a wardrobe in line with the door") == "none");
}

TEST_CASE("a heading may name a thing on which, or beside which, what follows is") {
  const Brief brief = read_brief("A study with a desk and a plant. On the desk: a monitor, a keyboard and a lamp. A sofa.");
  REQUIRE(things(brief) == "1 desk, 1 plant, 1 monitor, 1 keyboard, 1 table lamp, 1 sofa");
  for (const std::size_t thing : {2u, 3u, 4u}) CHECK(places(brief, thing) == "on, desk");
  CHECK(places(brief, 5).empty());
}

TEST_CASE("a side may have an owner, and left goes with right") {
  // The sides of who looks at the thing, as "left of" has them.
  const auto said = [](const char* prompt, std::size_t mention) { return places(read_brief(prompt), mention); };
  CHECK(said("A nursery with a crib. To the crib's left, a changing table.", 1) ==
        said("A nursery with a crib. To the left of the crib, a changing table.", 1));
  CHECK(said("A study with a desk. A cabinet stands to the desk's right side.", 1) ==
        said("A study with a desk. A cabinet stands to the right of the desk.", 1));
  CHECK(said("A bathroom with a bathtub and a stool at its right.", 1) ==
        said("A bathroom with a bathtub and a stool to the right of the bathtub.", 1));
  const Brief both = read_brief("A living room with a sofa. Left of the sofa stands an armchair; to its right, a plant.");
  CHECK(places(both, 1).ends_with("of, sofa"));
  CHECK(places(both, 2).ends_with("of, sofa"));
  CHECK(places(both, 1) != places(both, 2));
}

TEST_CASE("what is above it hangs above what the clause is about") {
  CHECK(places(read_brief("A bedroom with a bed. A dresser faces the bed with a mirror hung above it."), 2) == "above, dresser");
  CHECK(places(read_brief("A bedroom with a bed. A bench stands by the wall with a picture over it."), 2).starts_with("above, bench"));
}

TEST_CASE("what a thing does behind its name is no part of the name") {
  CHECK(places(read_brief("A nursery with a crib with a mobile hanging above it and a dresser."), 1) == "above, crib");
  CHECK(places(read_brief("A bedroom with a bed and a blanket lying on it."), 1) == "on, bed");
  CHECK(things(read_brief("A hallway with a bench and a wall hanging above it.")).find("tapestry") != std::string::npos);
  CHECK(things(read_brief("A hallway with a painting above the bench.")).find("picture") != std::string::npos);
}

TEST_CASE("parts that only some kinds have tell what is meant") {
  const Brief brief = read_brief("A bedroom. A nightstand stands on each side of the bed. At the foot lies a bench.");
  CHECK(things(brief).find("bench") != std::string::npos);
  CHECK(places(brief, brief.mentions.size() - 1).find("in front of, bed") != std::string::npos);
  CHECK(places(read_brief("A meeting room with a table. A phone lies at the table's centre."), 1) == "on, conference table");
}

TEST_CASE("several things side by side are a row") {
  const Brief brief = read_brief("A study with a bunk bed and two desks side by side.");
  REQUIRE(brief.mentions.size() == 2);
  CHECK(brief.mentions[1].formation);
  CHECK(brief.mentions[1].demands.empty());
  CHECK(!read_brief("A study with a desk and a cabinet side by side.").mentions[1].formation);
}

TEST_CASE("racks are what the room has racks for") {
  CHECK(things(read_brief("a server room with eight racks")) == "8 server rack");
  CHECK(things(read_brief("a gym with a rack")) == "1 dumbbell rack");
  CHECK(things(read_brief("a boutique with two rails")) == "2 clothes rack");
}

TEST_CASE("what is said of some of several makes them things of their own") {
  const Brief tables = read_brief("A restaurant with five square tables, three along the left wall and two along the right wall.");
  CHECK(things(tables) == "2 table, 3 table");
  CHECK(places(tables, 0) == "edge | near, wall-1 | face same as, wall-1");
  CHECK(places(tables, 1) == "edge | near, wall-3 | face same as, wall-3");
  const Brief beds = read_brief("A dormitory with three bunk beds. Two bunk beds are against the left wall and one is against the right wall.");
  CHECK(std::count_if(beds.mentions.begin(), beds.mentions.end(), [](const Mention& one) { return one.quantity > 0; }) == 2);
  const Brief chairs = read_brief("A living room with six chairs around a table. Two of the chairs face the window.");
  CHECK(things(chairs) == "4 chair, 1 table, 2 chair");
  const Brief sides = read_brief("A meeting room with an oval table and ten chairs, four on each long side and one at each end.");
  CHECK(things(sides).ends_with("2 office chair, 8 office chair"));
  const Brief plants = read_brief("An office with four plants, one in each corner.");
  CHECK(things(plants) == "4 plant");
  const Brief colours = read_brief("A garage with two tool cabinets, one red and one black.");
  CHECK(colours.mentions.size() == 2);
  CHECK(colours.mentions[1].looks == std::vector<std::string>{"red"});
}

TEST_CASE("some of them may be told of behind a pronoun") {
  for (const char* prompt : {"A bistro with five tables, two of them red.", "A room with five tables, two of which are red."}) {
    INFO(prompt);
    const auto brief = read_brief(prompt);
    REQUIRE(brief.mentions.size() == 2);
    CHECK(brief.mentions[0].quantity == 3);
    CHECK(brief.mentions[1].quantity == 2);
    CHECK(brief.mentions[1].looks == std::vector<std::string>{"red"});
  }
}

TEST_CASE("what is behind a thing stays what is checked, however it is made") {
  const auto brief = read_brief("A sofa with a bookshelf behind it.");
  REQUIRE(brief.mentions.size() == 2);
  const auto& demands = brief.mentions[1].demands;
  REQUIRE(demands.size() == 1);
  CHECK(demands[0].said == RelationKind::behind);
  CHECK(demands[0].said_of == 0);
}

TEST_CASE("what things are to each other is said of one and the other") {
  const Brief brief = read_brief("A lobby with two sofas facing each other.");
  REQUIRE(things(brief) == "1 sofa, 1 sofa");
  CHECK(places(brief, 1) == "in front of, sofa | face to, sofa");
}

TEST_CASE("a half of the room is a place for several things too") {
  const Brief brief = read_brief("A nursery. Four cribs stand in the left half of the room.");
  CHECK(places(brief, 0) == "in part, west-half");
}

TEST_CASE("a place behind a list of places belongs to those that came since the last") {
  const Brief brief = read_brief("A kitchen. There are a pot and a pan on the stove, a toaster and a kettle on the counter.");
  REQUIRE(brief.mentions.size() == 6);
  for (const auto& mention : brief.mentions)
    CHECK(mention.demands.size() <= 1);
}

TEST_CASE("another kind of thing, and somebody else's, is another thing") {
  CHECK(things(read_brief("A bedroom with two table lamps. An armchair stands beside a floor lamp.")) ==
        "2 table lamp, 1 armchair, 1 floor lamp");
  const Brief desks = read_brief("A classroom with 20 student desks. The teacher's desk is in front of the blackboard.");
  CHECK(things(desks).starts_with("20 student desk, 1 "));
}

TEST_CASE("a stand is a stand for what is on it") {
  CHECK(things(read_brief("A living room with a TV on a stand.")) == "1 tv, 1 tv stand");
}

TEST_CASE("who is told of may be what is not asked for") {
  CHECK(things(read_brief("A living room with a daybed. If I see a desk I'll work.")) == "1 daybed");
}

TEST_CASE("it is what can be so: one thing, that carries") {
  const Brief brief = read_brief("An office. The desk is by the door with a floor lamp behind it; on it are a phone and a clock.");
  CHECK(places(brief, 2) == "on, desk");
}
