// Several rooms: which ones a prompt asks for, what is said of each, and how they lie together.
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "brief/dwelling_kinds.h"
#include "brief/dwelling_prompt.h"
#include "brief/prompt.h"
#include "brief/room_kinds.h"
#include "catch.h"
#include "plan/dwelling_layout.h"
#include "plans.h"
#include "roomgen/base/json.h"
#include "roomgen/design/designer.h"
#include "scene/dwelling.h"

using namespace roomgen;
using namespace roomgen::brief;
using namespace roomgen::plan;

namespace {

std::optional<SaidDwelling> said(const std::string& prompt) {
  return read_dwelling(prompt, *built_in_dwelling_kinds(), *built_in_room_kinds(),
                       KindTable::built_in());
}

// "bathroom 1, bedroom 2"
std::string rooms_in(const std::string& prompt) {
  const auto dwelling = said(prompt);
  if (!dwelling) return "";
  std::map<std::string, int> counts;
  for (const auto& room : dwelling->rooms) ++counts[room.type];
  std::string text;
  for (const auto& [type, count] : counts)
    text += (text.empty() ? "" : ", ") + type + " " + std::to_string(count);
  return text;
}

std::vector<Room> rooms_of_prompt(const std::string& prompt, std::uint64_t seed) {
  const auto designer = make_rule_designer();
  PlanRequest request;
  request.prompt = prompt;
  request.seed = seed;
  const auto plan = plan_dwelling(request, *designer);
  REQUIRE(plan);
  REQUIRE(*plan);
  std::vector<Room> rooms;
  for (const auto& room : (*plan)->rooms) rooms.push_back(room.room);
  return rooms;
}

const char* const prompts[] = {
    "a two-bedroom apartment with a kitchen, a bathroom and a living room",
    "a studio with a separate bathroom",
    "a bedroom with an en-suite bathroom and a walk-in closet",
    "a hallway leading to two bedrooms",
    "a living room and a kitchen",
    "a four-bedroom house with two bathrooms, a study and a laundry room",
    "a 55 m2 apartment with a bedroom, a living room, a kitchen and a bathroom"};

}  // namespace

TEST_CASE("The rooms of a prompt") {
  CHECK(rooms_in("a two-bedroom apartment with a kitchen, a bathroom and a living room") ==
        "bathroom 1, bedroom 2, kitchen 1, living room 1");
  // A play kitchen is no room.
  CHECK(rooms_in("a nursery with a play kitchen and a doll house").empty());
  CHECK(rooms_in("a modern three-bedroom house") ==
        "bathroom 1, bedroom 3, hallway 1, kitchen 1, living room 1");
  CHECK(rooms_in("a studio with a separate bathroom") == "bathroom 1, studio 1");
  CHECK(rooms_in("a bedroom with an en-suite bathroom and a walk-in closet") ==
        "bathroom 1, bedroom 1, walk-in closet 1");
  CHECK(rooms_in("a hallway leading to two bedrooms") == "bedroom 2, hallway 1");
  CHECK(rooms_in("A kitchen with an island and a living room. The kitchen has bar stools.") ==
        "kitchen 1, living room 1");
  CHECK(rooms_in("an apartment with living room, kitchen and two bathrooms") ==
        "bathroom 2, kitchen 1, living room 1");
  // No dwelling is without a bathroom, unless it shall be.
  CHECK(rooms_in("a two-bedroom apartment with an open kitchen and a balcony") ==
        "balcony 1, bathroom 1, bedroom 2, kitchen 1, living room 1");
  CHECK(rooms_in("a one-bedroom flat with a living room, a bedroom with a double bed, a kitchen and a bathroom") ==
        "bathroom 1, bedroom 1, kitchen 1, living room 1");
  CHECK(rooms_in("Kitchen with a table for five, living room with a sofa, bathroom with a shower.") ==
        "bathroom 1, kitchen 1, living room 1");
  CHECK(rooms_in("a flat without a bathroom, with a living room and a bedroom") == "bedroom 1, living room 1");
}

TEST_CASE("Prompts about one room stay with one room") {
  for (const std::string prompt :
       {"a cosy bedroom for two", "a living room with a dining area", "a bedroom with a study nook",
        "a kitchen with a kitchen island and bar stools", "a living room in an apartment",
        "a bathroom with a bathroom cabinet next to the bathtub", "a bedroom like a hotel room",
        "a living room with a kitchen corner", "an apartment living room with a sofa",
        "a dining room next to the kitchen", "The bedroom has a bed and a bedroom bench.",
        "a combined living room and dining room", "a cosy apartment with a sofa and a bed",
        "a home office with a home gym corner", "a room with a bed, a desk and a wardrobe"}) {
    INFO(prompt);
    CHECK(rooms_in(prompt) == "");
  }
}

TEST_CASE("Clauses go to the room that they are said of") {
  const auto has = [](const SaidRoom& room, const std::string& text) {
    const auto& words = room.brief.tokens;
    return std::any_of(words.begin(), words.end(), [&](const auto& word) { return word.is(text); });
  };
  const auto dwelling =
      said("A two-bedroom flat with a kitchen with an island, a living room and a bathroom. "
           "The first bedroom has a desk. A bookshelf stands in the living room and a rug in the "
           "bathroom. There is a piano and a bathtub. Both bedrooms have a plant.");
  REQUIRE(dwelling);
  REQUIRE(dwelling->rooms.size() == 5);
  std::map<std::string, std::vector<const SaidRoom*>> by_type;
  for (const auto& room : dwelling->rooms) by_type[room.type].push_back(&room);
  CHECK(has(*by_type["kitchen"][0], "island"));
  CHECK(has(*by_type["bedroom"][0], "desk"));
  CHECK_FALSE(has(*by_type["bedroom"][1], "desk"));
  CHECK(has(*by_type["bedroom"][0], "plant"));
  CHECK(has(*by_type["bedroom"][1], "plant"));
  CHECK(has(*by_type["living room"][0], "bookshelf"));
  CHECK_FALSE(has(*by_type["bathroom"][0], "bookshelf"));
  CHECK(has(*by_type["bathroom"][0], "rug"));
  // What names no room stands where such things usually do.
  CHECK(has(*by_type["living room"][0], "piano"));
  CHECK(has(*by_type["bathroom"][0], "bathtub"));
}

TEST_CASE("A bathroom of a bedroom's own is entered from it alone") {
  const auto dwelling = said("two bedrooms, each with an en-suite bathroom, a living room and a kitchen");
  REQUIRE(dwelling);
  int owned = 0;
  for (const auto& room : dwelling->rooms)
    if (room.owner != SaidRoom::none) {
      ++owned;
      CHECK(room.type == "bathroom");
      CHECK(dwelling->rooms[room.owner].type == "bedroom");
    }
  CHECK(owned == 2);
}

TEST_CASE("Dwellings are whole: one wall between rooms, a way to each, windows outside") {
  for (const std::string prompt : prompts)
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      INFO(prompt << " " << seed);
      const auto rooms = rooms_of_prompt(prompt, seed);
      REQUIRE(rooms.size() >= 2);
      CHECK(rooms.size() <= max_rooms);
      CHECK(check_dwelling(rooms));
      CHECK(rooms_without_access(rooms).empty());
      int entrances = 0;
      for (std::size_t i = 0; i < rooms.size(); ++i) {
        const auto shared = shared_stretches(rooms, i);
        CHECK(area(rooms[i].polygon) >= 3.0);
        CHECK(bounds(rooms[i].polygon).size().minCoeff() >= 1.2);
        CHECK_FALSE(shared.empty());
        for (const auto& opening : rooms[i].openings) {
          const bool between = std::any_of(shared.begin(), shared.end(), [&](const SharedStretch& s) {
            return s.wall == opening.wall && s.from < opening.to && opening.from < s.to;
          });
          entrances += opening.is_entrance() && opening.leads_to.empty();
          CHECK(between == !opening.leads_to.empty());
          if (opening.is_entrance())
            CHECK(contains(rooms[i].polygon, door_clearance(rooms[i], opening)));
        }
      }
      CHECK(entrances == 1);
    }
}

TEST_CASE("Random lists of rooms are packed without overlaps") {
  const auto& kinds = *built_in_dwelling_kinds();
  std::vector<std::string> types;
  for (const auto& [type, kind] : kinds.rooms) types.push_back(type);
  Random random(5);
  for (int n = 0; n < 300; ++n) {
    std::vector<LaidRoom> rooms;
    const int count = random.integer(2, 11);
    for (int i = 0; i < count; ++i) {
      LaidRoom room;
      room.type = random.pick(types);
      const auto& kind = kinds.rooms.at(room.type);
      room.area = random.uniform(0.75 * kind.area.low, 2.0 * kind.area.high);
      if (i > 0 && random.chance(0.3)) room.parent = static_cast<std::size_t>(random.integer(0, i - 1));
      rooms.push_back(room);
    }
    INFO(n << " of " << count);
    const auto laid = lay_out(rooms, kinds);
    CHECK(laid.size() <= max_rooms);
    int hubs = 0;
    for (std::size_t i = 0; i < laid.size(); ++i) {
      hubs += laid[i].parent == LaidRoom::none;
      CHECK(laid[i].box.size().minCoeff() > 1.0);
      for (std::size_t k = 0; k < i; ++k) {
        // Apart by a wall at least, in one direction.
        const Vec2 gap = (laid[i].box.low - laid[k].box.high).cwiseMax(laid[k].box.low - laid[i].box.high);
        CHECK(gap.maxCoeff() >= wall_thickness - 1e-9);
      }
    }
    CHECK(hubs == 1);
  }
}

TEST_CASE("Too many rooms are bounded and told of") {
  const auto dwelling = said("a house with eight bedrooms, eight bathrooms and a kitchen");
  REQUIRE(dwelling);
  CHECK(dwelling->rooms.size() == max_rooms - 1);
  CHECK_FALSE(dwelling->notes.empty());
}

TEST_CASE("Equal requests give equal dwellings, other seeds others") {
  const auto text = [](std::uint64_t seed) {
    const auto designer = make_rule_designer();
    PlanRequest request;
    request.prompt = prompts[0];
    request.seed = seed;
    return dump_json(to_json(**plan_dwelling(request, *designer)));
  };
  CHECK(text(3) == text(3));
  CHECK(text(3) != text(4));
}

TEST_CASE("A floor plan or a size of one room asks for one room") {
  const auto designer = make_rule_designer();
  PlanRequest request;
  request.prompt = prompts[0];
  request.size = Vec2(4, 5);
  const auto plan = plan_dwelling(request, *designer);
  REQUIRE(plan);
  CHECK_FALSE(plan->has_value());
}

TEST_CASE("A bedroom that is too narrow for the bed that was drawn has a smaller one") {
  for (int seed = 0; seed < 8; ++seed) {
    PlanRequest request;
    request.prompt = "a bedroom of 2.1 by 4 m";
    request.seed = static_cast<std::uint64_t>(seed);
    const auto plan = make_rule_designer()->plan(request);
    REQUIRE(plan);
    CHECK(std::any_of(plan->items.begin(), plan->items.end(), [](const PlanItem& item) { return item.category == "bed"; }));
  }
}

TEST_CASE("What is said of everything behind the rooms is said of each") {
  const auto dwelling = said("a flat with a bedroom and a bathroom, everything in cream and gold");
  REQUIRE(dwelling);
  REQUIRE(dwelling->rooms.size() >= 2);
  for (const auto& room : dwelling->rooms) {
    INFO(room.type);
    Brief own = room.brief;
    conclude(own, *built_in_room_kinds(), KindTable::built_in());
    CHECK(own.palette == std::vector<std::string>{"cream", "gold"});
  }
}
