// Sentences to operations, on a room of boxes.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "base/random.h"
#include "edit_words.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

Scene bedroom() {
  Room room = rooms::box(5.0, 4.0);
  room.openings = {rooms::door("door-0", 0, 0.3, 1.2), rooms::window("window-0", 2, 1.5, 3.0)};
  Object lamp = rooms::thing("table lamp-0", "table lamp", {0.2, 0.2, 0.4}, {4.0, 2.0});
  lamp.mount = Mount::surface;
  lamp.on = "desk-0";
  lamp.position.z() = 0.75;
  return rooms::scene(room, {rooms::thing("double bed-0", "double bed", {1.6, 2.0, 0.5}, {1.5, 2.9}),
                             rooms::thing("chair-0", "chair", {0.5, 0.5, 0.9}, {1.0, 1.0}),
                             rooms::thing("chair-1", "chair", {0.5, 0.5, 0.9}, {3.0, 1.0}),
                             rooms::thing("desk-0", "desk", {1.2, 0.6, 0.75}, {4.0, 2.0}),
                             rooms::thing("rug-0", "rug", {1.0, 1.0, 0.01}, {2.4, 0.9}), lamp});
}

std::string read(const std::string& sentence, const Recall& recall = {}) {
  const Scene scene = bedroom();
  const auto operations = read_edit(sentence, scene, KindTable::built_in(), recall);
  if (!operations) {
    CHECK(operations.error().kind == Error::Kind::not_understood);
    return operations.error().message;
  }
  std::string text;
  for (const auto& operation : operations->operations) text += (text.empty() ? "" : "; ") + edit::to_json(operation).dump();
  return text;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("Sentences become operations") {
  const std::pair<const char*, const char*> cases[] = {
      {"remove the lamp", R"({"do":"remove","objects":["table lamp-0"]})"},
      {"please get rid of both chairs", R"({"do":"remove","objects":["chair-0","chair-1"]})"},
      {"clear everything off the desk", R"({"do":"remove","objects":["table lamp-0"]})"},
      {"move the left chair to the desk", R"({"do":"move","object":"chair-0","relations":["near, desk-0"]})"},
      {"turn the right chair to the window", R"({"do":"face","object":"chair-1","target":"window-0"})"},
      {"turn the bed around", R"({"do":"turn","object":"double bed-0","by_deg":180.0})"},
      {"rotate the desk 45 degrees clockwise", R"({"do":"turn","object":"desk-0","by_deg":-45.0})"},
      {"swap the bed and the desk", R"({"do":"swap","first":"double bed-0","second":"desk-0"})"},
      {"shift the bed 30 cm to the right", R"({"do":"shift","object":"double bed-0","by":[0.3,0.0,0.0]})"},
      {"move chair-1 in front of the desk", R"({"do":"move","object":"chair-1","relations":["in front of, desk-0"]})"},
      {"add a floor lamp in the corner",
       R"({"do":"add","category":"floor lamp","description":"floor lamp","relations":["corner"]})"},
      {"lock the bed and unlock the desk",
       R"({"do":"lock","objects":["double bed-0"],"locked":true}; {"do":"lock","objects":["desk-0"],"locked":false})"},
      {"paint the bed white and the desk dark green",
       R"({"do":"recolor","object":"double bed-0","looks":"white"}; {"do":"recolor","object":"desk-0","looks":"dark green"})"},
      {"make the desk 20 cm wider", R"({"do":"resize","object":"desk-0","size":[1.4,0.6,0.75]})"},
      {"walls sage green", R"({"do":"cover","part":"walls","looks":"sage green"})"},
      {"bed under the window", R"({"do":"move","object":"double bed-0","relations":["under, window-0"]})"},
      {"move the lamp off the desk onto the bed", R"({"do":"move","object":"table lamp-0","relations":["on, double bed-0"]})"},
      {"the bed should face the window", R"({"do":"face","object":"double bed-0","target":"window-0"})"},
      {"the rug has to go", R"({"do":"remove","objects":["rug-0"]})"},
      {"get rid of one of the chairs", R"({"do":"remove","objects":["chair-1"]})"},
      {"hang a picture over the bed",
       R"({"do":"add","category":"picture","description":"picture","relations":["above, double bed-0"]})"},
      {"undo that", R"({"do":"revert"})"},
      {"replace the bed with a single bed",
       R"({"do":"replace","object":"double bed-0","category":"single bed","description":"single bed"})"}};
  for (const auto& [sentence, expected] : cases) {
    INFO(sentence);
    CHECK(read(sentence) == expected);
  }
}

TEST_CASE("What may mean several things is asked back, with the choices") {
  for (const char* sentence : {"remove the chair", "turn the chair to the window", "paint the chair red",
                               "move the chair next to the bed", "make the chair bigger"}) {
    INFO(sentence);
    CHECK(contains(read(sentence), "chair-0, chair-1"));
  }
}

TEST_CASE("What is not understood, or only in part, changes nothing") {
  for (const char* sentence : {"", "make it nicer", "remove the piano", "move the desk over there", "remove everything",
                               "frobnicate the bed", "put the bed on the frobnicator", "paint the bed blurple",
                               "move the bed", "turn the bed", "add", "remove the bed legs",
                               "swap the bed", "move the bed 30", "add a chair and frobnicate", "remove all three chairs",
                               "move the lamp on the shelf to the bed", "buy milk", "it", "put it on the desk"}) {
    INFO(sentence);
    const std::string message = read(sentence);
    INFO(message);
    CHECK(!contains(message, "{\"do\""));
  }
}

TEST_CASE("It means what was spoken of last, or what the edit before was about") {
  CHECK(read("turn it around", {{"desk-0"}, {}}) == R"({"do":"turn","object":"desk-0","by_deg":180.0})");
  CHECK(contains(read("move the desk to the corner and turn it around"), R"({"do":"turn","object":"desk-0")"));
  CHECK(contains(read("add a plant and put it next to the bed"),
                 R"("relations":["next to)"));
  CHECK(contains(read("remove the chair you just added", {{}, {"chair-1"}}), R"(["chair-1"])"));
}

TEST_CASE("What a clause is about may come first, and reasons ask for nothing") {
  CHECK(read("the bed and the desk should change places") == read("swap the bed and the desk"));
  CHECK(read("the lamp can be removed") == read("remove the lamp"));
  CHECK(read("the rug is to be painted blue") == read("paint the rug blue"));
  CHECK(read("our cat scratches everything, so remove the rug") == read("remove the rug"));
  CHECK(read("the desk is too wide for me, make it 20 % narrower") == read("make the desk 20 % narrower"));
  CHECK(read("remove the lamp because the kids break it") == read("remove the lamp"));
  CHECK(read("rug: smaller by a quarter") == read("make the rug smaller by a quarter"));
  CHECK(contains(read("an armchair instead of the desk"), R"("do":"replace","object":"desk-0","category":"armchair")"));
  CHECK(contains(read("chair number two should go"), "chair-1"));
  CHECK(read("remove the rug, it is so dark here") == read("remove the rug"));
  CHECK(!contains(read("make the desk -3 m wide"), R"("do")"));
  // A wish that is not understood is no remark.
  CHECK(!contains(read("we want the bed to be happier, remove the rug"), R"("do")"));
  CHECK(!contains(read("remove the rug, the bed must fly"), R"("do")"));
}

TEST_CASE("Sentences change the room itself") {
  CHECK(read("add a window in the left wall") == R"({"do":"open","kind":"window","wall":"wall-3"})");
  CHECK(read("brick up the window") == R"({"do":"close","openings":["window-0"]})");
  CHECK(read("raise the ceiling to 3 m") == R"({"do":"reshape","height":3.0})");
  CHECK(read("move the right wall out by 50 cm") == R"({"do":"reshape","wall":"wall-1","by":0.5})");
  CHECK(read("make the room 1 m wider") == R"({"do":"reshape","wall":"wall-1","by":1.0})");
  CHECK(contains(read("make the window 20 cm wider"), R"({"do":"refit","opening":"window-0","width")"));
  CHECK(contains(read("make the legs of the desk thinner"), R"({"do":"reform","object":"desk-0","words":"with thinner legs"})"));
}

TEST_CASE("The place of a thing may be where another stands, or a part of one") {
  CHECK(contains(read("move the left chair to where the rug is"), R"({"do":"put","object":"chair-0","position":[2.4,0.9]})"));
  CHECK(read("put the desk where the bed is and the bed where the desk is") == R"({"do":"swap","first":"desk-0","second":"double bed-0"})");
  CHECK(read("what if the bed were where the desk is, and vice versa?") == R"({"do":"swap","first":"desk-0","second":"double bed-0"})");
  CHECK(contains(read("remove the rug and put the desk in its place"), R"({"do":"put","object":"desk-0","position":[2.4,0.9]})"));
  CHECK(contains(read("slide the lamp to the left edge of the desk"), R"("do":"put","object":"table lamp-0","position")"));
  CHECK(read("stand chair-1 at the front of the desk") == R"({"do":"move","object":"chair-1","relations":["in front of, desk-0"]})");
}

TEST_CASE("A distance that shall be left is kept by moving straight") {
  // Between the chairs there are 1.5 m.
  CHECK(contains(read("leave 1 m between the left chair and the right chair"), R"("by":[0.5,0.0,0.0])"));
  CHECK(contains(read("there should be a gap of 120 cm from chair-1 to chair-0"), R"({"do":"shift","object":"chair-1","by":[-0.3,0.0,0.0]})"));
  CHECK(contains(read("chair-1 needs 1.6 m of free space to chair-0"), R"({"do":"shift","object":"chair-1","by":[0.1,0.0,0.0]})"));
}

TEST_CASE("Each of several gets one") {
  CHECK(contains(read("put a cushion on each chair"), R"("relations":["on, chair-1"])"));
  CHECK(contains(read("every chair should have a cushion"), R"(, chair-1"])"));
  CHECK(contains(read("add one plant at either end of the desk"), "desk-0"));
  CHECK(contains(read("put the chairs on either side of the desk"), R"({"do":"move","object":"chair-1","relations":["right of, desk-0"]})"));
  CHECK(contains(read("add a plant in each corner"), "north-west-quarter"));
  CHECK(contains(read("move the left chair to the desk, and the right chair too"), R"({"do":"move","object":"chair-1","relations":["near, desk-0"]})"));
}

TEST_CASE("Words behind a name tell which is meant") {
  CHECK(read("remove the chair nearest the desk") == read("remove chair-1"));
  CHECK(read("remove the chair farthest from the desk") == read("remove chair-0"));
  CHECK(read("paint the chair on the left blue") == read("paint chair-0 blue"));
  CHECK(read("remove the second chair from the left") == read("remove chair-1"));
  CHECK(read("remove any chair that isn't next to the desk") != read("remove both chairs"));
  CHECK(contains(read("turn the chair we just put in to the window", {{}, {"chair-1"}}), "chair-1"));
  CHECK(read("of the two chairs only the left one may stay") == read("remove chair-1"));
  CHECK(read("one chair is enough") == read("remove chair-1"));
}

TEST_CASE("What is there may be called by other words, and misspelt") {
  CHECK(read("remove the carpet") == read("remove the rug"));
  CHECK(read("remvoe the rug") == read("remove the rug"));
  CHECK(read("put teh lamp on the bed") == read("put the lamp on the bed"));
}

TEST_CASE("What is taken back counts for nothing") {
  CHECK(read("remove the rug, no, the desk") == read("remove the desk"));
  CHECK(read("put the lamp on the chair, sorry, no, on the bed") == read("put the lamp on the bed"));
  CHECK(read("paint the bed red, I mean dark blue") == read("paint the bed dark blue"));
  CHECK(!contains(read("remove the rug, no wait, frobnicate it"), R"("do")"));
}

TEST_CASE("Questions and wishes are orders") {
  CHECK(read("could the bed go under the window?") == read("bed under the window"));
  CHECK(contains(read("a plant next to the bed would be lovely"), R"("do":"add","category":"plant")"));
  CHECK(read("no rug please") == read("remove the rug"));
  CHECK(contains(read("we need a bigger desk"), R"("do":"replace","object":"desk-0","description":"bigger desk")"));
  CHECK(read("the rug isn't needed any more") == read("remove the rug"));
  CHECK(read("can we have both chairs face each other") ==
        R"({"do":"face","object":"chair-0","target":"chair-1"}; {"do":"face","object":"chair-1","target":"chair-0"})");
}

TEST_CASE("Looks and likeness are part of what comes") {
  CHECK(contains(read("replace the bed with something in brown leather"), R"("description":"in brown leather double bed")"));
  CHECK(contains(read("add a floor lamp in dark brass next to the bed"), R"("description":"floor lamp in dark brass")"));
  CHECK(contains(read("instead of the desk, a round one, in pale ash"), R"(in pale ash")"));
  CHECK(!contains(read("instead of the desk, a round one, in pale ash"), "recolor"));
}

TEST_CASE("Rooms of a dwelling tell things apart and are places") {
  Scene scene = bedroom();
  Room first = scene.room, second = scene.room;
  first.id = "bedroom-0", first.type = "bedroom", second.id = "living-room-0", second.type = "living room";
  scene.room = Room();
  scene.rooms = {first, second};
  for (auto& object : scene.objects) object.room = object.id == "chair-1" ? second.id : first.id;
  const auto read_here = [&](const char* sentence) {
    const auto understood = read_edit(sentence, scene, KindTable::built_in(), {});
    return understood ? edit::to_json(understood->operations.front()).dump() : understood.error().message;
  };
  CHECK(read_here("remove the chair in the living room") == R"({"do":"remove","objects":["chair-1"]})");
  CHECK(read_here("move the desk to the living room") == R"({"do":"move","object":"desk-0","relations":[],"room":"living-room-0"})");
  CHECK(contains(read_here("add a plant in the bedroom"), R"("room":"bedroom-0")"));
}

TEST_CASE("Politeness and short forms change nothing") {
  const std::string plain = read("remove the rug");
  for (const char* sentence : {"could you please remove the rug?", "would you be so kind as to remove the rug", "delete please the rug",
                               "I'd like you to remove the rug", "why not remove the rug",
                               "you know what, remove the rug", "remove the rug while you're at it", "remove the rug so I can dance",
                               "remove the rug, not the desk", "it would be nice if you could remove the rug"}) {
    INFO(sentence);
    CHECK(read(sentence) == plain);
  }
}

TEST_CASE("Sizes are said in many ways") {
  const std::string longer = R"({"do":"resize","object":"desk-0","size":[1.4,0.6,0.75]})";
  for (const char* sentence : {"make the desk 20 cm longer", "lengthen the desk by 20 cm", "the desk should be 20 cm longer", "increase the width of the desk by 20 cm",
                               "set the desk's width to 1.4 m", "make the desk 1.4 m wide", "I want the desk 20 cm wider"}) {
    INFO(sentence);
    CHECK(read(sentence) == longer);
  }
  CHECK(read("make the desk twice as wide") == read("make the desk double the width"));
  CHECK(read("halve the height of the desk") == read("make the desk half as tall"));
  CHECK(read("scale the desk by 1.5") == read("make the desk 50 % bigger"));
  CHECK(read("the desk needs to be wider by half a metre") == read("make the desk 50 cm wider"));
}

TEST_CASE("A complaint says what is wanted, unless what follows says it") {
  CHECK(contains(read("the bed is too close to the desk"), R"("relations":["far, desk-0"])"));
  CHECK(contains(read("the left chair is too far from the desk"), R"("relations":["near, desk-0"])"));
  CHECK(contains(read("the bed is blocking the window"), R"("relations":["far, window-0"])"));
  CHECK(read("the rug is too small") == read("make the rug bigger"));
  CHECK(read("the desk is too close to the bed, move it to the right by 30 cm") == read("move the desk 30 cm to the right"));
  CHECK(contains(read("the bed is blocking the window, move it"), R"("far, window-0")"));
}

TEST_CASE("A place may come first, and an order may leave out its object") {
  CHECK(read("on the desk, put a vase") == read("put a vase on the desk"));
  CHECK(read("in the corner I'd like a plant") == read("add a plant in the corner"));
  CHECK(read("30 cm to the right with the bed") == read("move the bed 30 cm to the right"));
  CHECK(read("desk: move 30 cm left, rotate 90 degrees") == read("move the desk 30 cm left and turn it 90 degrees"));
  CHECK(read("I want the bed moved to the corner") == read("move the bed to the corner"));
}

TEST_CASE("Others, exceptions and those nearest to something") {
  CHECK(contains(read("turn the left chair around and move the other chair to the bed"), R"("object":"chair-1","relations":["near, double bed-0"])"));
  CHECK(contains(read("put a plant next to the chair closest to the desk"), "chair-1"));
  CHECK(!contains(read("paint everything white except the bed"), "double bed-0"));
  CHECK(contains(read("paint everything white except the bed"), "desk-0"));
  CHECK(contains(read("remove half of the chairs"), R"(["chair-1"])"));
  CHECK(contains(read("the desk needs a thicker top"), R"("do":"reform")"));
}

TEST_CASE("Words that nobody knows never leave half an edit") {
  Random random(78);
  const std::vector<std::string> orders = {"remove the rug", "move the bed to the corner", "make the desk 20 cm wider", "paint the bed white",
                                           "turn the bed around", "swap the bed and the desk", "put a plant on the desk", "the desk should be red"};
  for (int round = 0; round < 40; ++round) {
    const std::string first = random.pick(orders), second = random.pick(orders);
    for (const std::string& unknown : {std::string("frobnicate the bed"), std::string("zorble the left chair"), std::string("quux the desk to the wobble")})
      for (const std::string& sentence : {first + " and " + unknown, unknown + " and " + second, first + ", then " + unknown + ", then " + second}) {
        INFO(sentence);
        CHECK(!contains(read(sentence), R"({"do")"));
      }
  }
}

TEST_CASE("No text breaks the reader") {
  Random random(77);
  const std::vector<std::string> pieces = {"move", "the", "chair", "to", "left", "of", "and", ",", "bed", "30 cm", "all", "two",
                                           "it", "everything", "except", "make", "bigger", "paint", "red", "\xff\xfe", "\"", "12",
                                           "swap", "with", "on", "each", "a", "between", "window", "wall", "nearest", "one", "degrees",
                                           "turn", "so that it faces", "chair-1", "-", "add", "second", "lamp", "back", "undo",
                                           "where", "gap", "of", "each", "other", "sorry", "no", "that", "isn't", "enough", "its", "end", "vice versa", "should", "be", "moved", "is", "too", "we", "because", "door", "room", "20 %", "smaller",
                                           "by", "a quarter", "instead of", "legs", "its", "taller", "ceiling", "raise", "close"};
  for (int round = 0; round < 800; ++round) {
    std::string sentence;
    for (int n = random.integer(0, 14); n > 0; --n) sentence += random.pick(pieces) + " ";
    const auto operations = read_edit(sentence, bedroom(), KindTable::built_in(), {{"desk-0"}, {}});
    if (!operations) CHECK(!operations.error().message.empty());
    else CHECK(!operations->operations.empty());
  }
}
