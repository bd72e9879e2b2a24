// Sentences about one room of a dwelling.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "edit_words.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

// A bedroom with two windows, a kitchen with one, a bathroom with none.
Scene flat() {
  const auto room = [](const char* id, const char* type, std::vector<Opening> openings) {
    Room one = rooms::box(4.0, 4.0);
    one.id = id, one.type = type, one.openings = std::move(openings);
    return one;
  };
  Scene scene;
  scene.rooms = {room("bedroom-0", "bedroom",
                      {rooms::door("door-0", 0, 0.3, 1.2), rooms::window("window-0", 2, 0.5, 1.5),
                       rooms::window("window-1", 2, 2.5, 3.5)}),
                 room("kitchen-0", "kitchen", {rooms::door("door-0", 0, 0.3, 1.2), rooms::window("window-0", 2, 1.5, 3.0)}),
                 room("bathroom-0", "bathroom", {rooms::door("door-0", 0, 0.3, 1.2)})};
  const auto put = [&](const char* id, const char* category, const char* where) {
    scene.objects.push_back(rooms::thing(id, category, {0.5, 0.5, 0.8}, {1.0, 2.0}));
    scene.objects.back().room = where;
  };
  put("double bed-0", "double bed", "bedroom-0");
  put("chair-0", "chair", "bedroom-0");
  put("stove-0", "stove", "kitchen-0");
  put("chair-1", "chair", "kitchen-0");
  return scene;
}

std::string read_of_flat(const std::string& sentence) {
  const Scene scene = flat();
  const auto understood = read_edit(sentence, scene, KindTable::built_in(), {});
  if (!understood) {
    CHECK(understood.error().kind == Error::Kind::not_understood);
    return understood.error().message;
  }
  std::string text;
  for (const auto& one : understood->operations) text += (text.empty() ? "" : "; ") + edit::to_json(one).dump();
  return text;
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string covering(const std::string& part, const std::string& looks, const std::string& room) {
  return R"({"do":"cover","part":")" + part + R"(","looks":")" + looks + R"(","room":")" + room + R"("})";
}

}  // namespace

TEST_CASE("Walls, floors and openings of a dwelling are those of the room that is named") {
  const std::pair<const char*, std::string> cases[] = {
      {"paint the walls of the kitchen yellow", covering("walls", "yellow", "kitchen-0")},
      {"paint the kitchen walls yellow", covering("walls", "yellow", "kitchen-0")},
      {"the kitchen's walls should be yellow", covering("walls", "yellow", "kitchen-0")},
      {"paint the bedroom pale blue", covering("walls", "pale blue", "bedroom-0")},
      {"make the bathroom floor dark tile", covering("floor", "dark tile", "bathroom-0")},
      {"in the kitchen, make the floor oak and paint the walls white",
       covering("floor", "oak", "kitchen-0") + "; " + covering("walls", "white", "kitchen-0")},
      {"paint the kitchen walls yellow and the bathroom floor blue",
       covering("walls", "yellow", "kitchen-0") + "; " + covering("floor", "blue", "bathroom-0")},
      {"the walls of the kitchen and the bathroom should be green",
       covering("walls", "green", "kitchen-0") + "; " + covering("walls", "green", "bathroom-0")},
      {"add a window in the bedroom", R"({"do":"open","kind":"window","room":"bedroom-0"})"},
      {"brick up the window in the kitchen", R"({"do":"close","openings":["kitchen-0/window-0"]})"},
      {"make the kitchen window 20 cm wider", R"({"do":"refit","opening":"kitchen-0/window-0","width":1.7})"},
      {"remove the chair in the kitchen and paint the bathroom white",
       R"({"do":"remove","objects":["chair-1"]}; )" + covering("walls", "white", "bathroom-0")}};
  for (const auto& [sentence, expected] : cases) {
    INFO(sentence);
    CHECK(read_of_flat(sentence) == expected);
  }
}

TEST_CASE("Walls that no word places are those of every room") {
  CHECK(read_of_flat("paint the walls white") == covering("walls", "white", "bedroom-0") + "; " +
                                             covering("walls", "white", "kitchen-0") + "; " +
                                             covering("walls", "white", "bathroom-0"));
  CHECK(read_of_flat("paint the walls white in all rooms") == read_of_flat("paint the walls white"));
}

TEST_CASE("A window that no word places is that of the room of what is named, or is asked back") {
  CHECK(read_of_flat("put the stove under the window") ==
        R"({"do":"move","object":"stove-0","relations":["under, window-0"]})");
  CHECK(read_of_flat("put the bed under window-1") ==
        R"({"do":"move","object":"double bed-0","relations":["under, window-1"]})");
  CHECK(says(read_of_flat("put the bed under the window"), "window-0 and window-1"));
  CHECK(says(read_of_flat("make the window wider"), "bedroom-0, kitchen-0"));
  CHECK(!says(read_of_flat("make the window wider"), "bathroom-0"));
  CHECK(says(read_of_flat("remove the window of the bathroom"), "no such"));
}
