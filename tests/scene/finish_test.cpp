#include <nlohmann/json.hpp>

#include "scene/finish.h"

#include "base/random.h"
#include "base/resource.h"
#include "catch.h"
#include "roomgen/base/json.h"

using namespace roomgen;

namespace {

bool same(const Finish& a, const Finish& b) {
  if (a.extent != b.extent || a.material.roughness != b.material.roughness ||
      a.material.base_color != b.material.base_color)
    return false;
  if (!a.material.texture || !b.material.texture) return a.material.texture == b.material.texture;
  return a.material.texture->pixels == b.material.texture->pixels;
}

Finish floor_of(const std::string& words) {
  return make_finish(words, RoomPart::floor, "bedroom");
}
Finish wall_of(const std::string& words) {
  return make_finish(words, RoomPart::walls, "bedroom");
}

}  // namespace

TEST_CASE("the words of materials are consistent") {
  const auto words = parse_finish_words(resource("data/materials.json").value_or(""), "materials");
  if (!words) FAIL(words.error().message);
  for (const auto& [phrase, part] : words->alone) {
    INFO(phrase);
    // What names its part of the room names what it is made of too.
    bool describes = false;
    for (const auto& [name, surface] : words->surface_names)
      describes = describes || (" " + phrase + " ").find(" " + name + " ") != std::string::npos;
    CHECK(describes);
  }
  for (const auto& [name, surface] : words->surfaces)
    for (const auto& [part, other] : surface.instead) {
      INFO(name);
      CHECK(words->surfaces.at(other).instead.count(part) == 0);  // no chains
    }
  for (const auto& filler : words->fillers) {
    INFO(filler);
    CHECK_FALSE(words->describes(filler));
    CHECK(words->parts.count(filler) == 0);
  }
}

TEST_CASE("what rooms usually wear is known by name") {
  const auto rooms = parse_json(resource("data/rooms.json").value_or(""), "rooms");
  REQUIRE(rooms);
  for (const auto& [type, room] : (*rooms)["types"].items())
    for (const auto* part : {"floors", "walls"})
      for (const auto& text : room.value(part, Json::array())) {
        INFO(type << ": " << text);
        const auto& words = finish_words();
        bool known = false;
        std::string description = text.get<std::string>();
        for (std::size_t from = 0; from <= description.size();) {
          const std::size_t to = std::min(description.find(' ', from), description.size());
          known = known || words.describes(description.substr(from, to - from));
          from = to + 1;
        }
        CHECK(known);
      }
}

TEST_CASE("every surface wears its pattern where it may") {
  const auto& words = finish_words();
  for (const auto& [name, surface] : words.surface_names) {
    INFO(name);
    const Surface& wanted = words.surfaces.at(surface);
    const RoomPart part = wanted.instead.count(RoomPart::floor) ? RoomPart::walls : RoomPart::floor;
    const Finish finish = make_finish(name, part, "hall");
    CHECK((finish.material.texture != nullptr) == wanted.pattern.has_value());
    if (wanted.pattern) CHECK(finish.extent == texture_extent(*wanted.pattern));
  }
}

TEST_CASE("a painted wall has the colour that is named, shades move it") {
  const auto& words = finish_words();
  for (const auto* list : {&words.colors, &words.basic_colors})
    for (const auto& [color, tone] : *list) {
      INFO(color);
      CHECK(wall_of(color + " walls").material.base_color == material_color(tone));
      CHECK(wall_of("dark " + color).material.base_color[0] < material_color(tone)[0]);
    }
  CHECK(same(wall_of("navy blue walls"), wall_of("navy walls")));
  // Between oak and white.
  const auto brightness = [](const Finish& finish) {
    double sum = 0.0;
    for (const auto value : finish.material.texture->pixels) sum += value;
    return sum;
  };
  CHECK(brightness(floor_of("oak floor")) < brightness(floor_of("white oak floor")));
  CHECK(brightness(floor_of("white oak floor")) < brightness(floor_of("white wooden floor")));
}

TEST_CASE("unknown words change nothing") {
  Random random(5);
  for (const std::string description :
       {"oak floor", "black and white checkerboard tiles", "sage green walls", "red brick wall"})
    for (int i = 0; i < 10; ++i) {
      std::string strange;
      for (int letter = 0; letter < 9; ++letter)
        strange += static_cast<char>('a' + random.integer(0, 25));
      CHECK(same(floor_of(description), floor_of(strange + "x " + description + " q" + strange)));
      CHECK(same(floor_of(""), floor_of(strange)));
    }
  CHECK(same(wall_of(""), wall_of(std::string(100000, 'w'))));
}

TEST_CASE("two tones are both there, in their order") {
  const Finish checks = floor_of("black and white checkerboard floor");
  const auto& image = *checks.material.texture;
  // The middles of two neighbouring squares.
  CHECK(image.at(image.width / 8, image.height / 8)[0] < 80);
  CHECK(image.at(3 * image.width / 8, image.height / 8)[0] > 200);
}

TEST_CASE("carpets do not climb walls") {
  CHECK_FALSE(wall_of("carpeted walls").material.texture);
  CHECK(floor_of("grey carpet").material.texture);
}

TEST_CASE("what is wrong in a file of materials is told with its place") {
  const std::string usual =
      R"("usual": {"floor": [{"surface": "a"}], "walls": [{"surface": "a"}], "ceiling": [{"surface": "a"}]})";
  const auto parse = [&](const std::string& surface, const std::string& more) {
    return parse_finish_words(R"({"surfaces": {"a": )" + surface + R"(}, )" + more + usual + "}",
                              "m.json");
  };
  REQUIRE(parse(R"({"names": ["a"], "tone": [1, 2, 3]})", ""));
  for (const auto& [surface, more] :
       {std::pair<std::string, std::string>{R"({"names": ["a"], "tone": [1, 2, 300]})", ""},
        {R"({"names": ["a"], "tone": [1, 2, 3], "pattern": "tartan"})", ""},
        {R"({"names": ["a", "a"], "tone": [1, 2, 3]})", ""},
        {R"({"names": ["a"], "tone": [1, 2, 3], "on walls": "b"})", ""},
        {R"({"names": ["a"], "tone": [1, 2, 3]})", R"("parts": {"roof": "roof"}, )"},
        {R"({"names": ["a"], "tone": [1, 2, 3]})",
         R"("substances": {"oak": {"tone": [1, 2, 3], "surface": "b"}}, )"}}) {
    INFO(surface << more);
    const auto words = parse(surface, more);
    REQUIRE_FALSE(words);
    CHECK(words.error().message.starts_with("m.json: /"));
  }
}
