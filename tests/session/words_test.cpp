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
  for (const auto& operation : *operations) text += (text.empty() ? "" : "; ") + edit::to_json(operation).dump();
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
                               "move the bed", "turn the bed", "add", "remove the bed legs", "make the bed's legs shorter",
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

TEST_CASE("No text breaks the reader") {
  Random random(77);
  const std::vector<std::string> pieces = {"move", "the", "chair", "to", "left", "of", "and", ",", "bed", "30 cm", "all", "two",
                                           "it", "everything", "except", "make", "bigger", "paint", "red", "\xff\xfe", "\"", "12",
                                           "swap", "with", "on", "each", "a", "between", "window", "wall", "nearest", "one", "degrees",
                                           "turn", "so that it faces", "chair-1", "-", "add", "second", "lamp", "back", "undo"};
  for (int round = 0; round < 3000; ++round) {
    std::string sentence;
    for (int n = random.integer(0, 14); n > 0; --n) sentence += random.pick(pieces) + " ";
    const auto operations = read_edit(sentence, bedroom(), KindTable::built_in(), {{"desk-0"}, {}});
    if (!operations) CHECK(!operations.error().message.empty());
    else CHECK(!operations->empty());
  }
}
