// Doors and windows as prompts ask for them: what is read, and the rooms that come of it.
#include <nlohmann/json.hpp>
#include <set>

#include "brief/brief.h"
#include "brief/prompt.h"
#include "catch.h"
#include "read_brief.h"
#include "plan/room_openings.h"
#include "plans.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "scene/opening_kind.h"
#include "support/shapes.h"

using namespace roomgen;
using namespace roomgen::brief;
using namespace roomgen::plan;

namespace {

Room room_of(const std::string& prompt, std::uint64_t seed = 0) {
  return test::plan_of(prompt, seed).room;
}

int count(const Room& room, OpeningType type, const std::string& kind = "") {
  int n = 0;
  for (const auto& opening : room.openings)
    n += opening.type == type && (kind.empty() || opening.kind == kind);
  return n;
}

// The side that an opening's wall is at, as the viewer of the plan names it.
std::string side(const Room& room, const Opening& opening) {
  const Vec2 out = -inward(room, opening);
  if (std::abs(out.x()) > std::abs(out.y())) return out.x() < 0 ? "left" : "right";
  return out.y() < 0 ? "front" : "back";
}

std::multiset<std::string> sides(const Room& room, OpeningType type, const std::string& kind = "") {
  std::multiset<std::string> found;
  for (const auto& opening : room.openings)
    if (opening.type == type && (kind.empty() || opening.kind == kind))
      found.insert(side(room, opening));
  return found;
}

using Sides = std::multiset<std::string>;

bool has_entrance(const Room& room) {
  return std::any_of(room.openings.begin(), room.openings.end(),
                     [](const Opening& opening) { return opening.is_entrance(); });
}

}  // namespace

TEST_CASE("The wall that is told is the viewer's") {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    CHECK(sides(room_of("a bedroom with a window on the left wall", seed), OpeningType::window) ==
          Sides{"left"});
    CHECK(sides(room_of("a bedroom with a large window in the back wall", seed),
                OpeningType::window) == Sides{"back"});
    CHECK(sides(room_of("an office. The door is on the right wall.", seed), OpeningType::door) ==
          Sides{"right"});
    CHECK(sides(room_of("a living room with windows on the left and right walls", seed),
                OpeningType::window) == Sides{"left", "right"});
    CHECK(sides(room_of("a kitchen. The front wall has two windows.", seed), OpeningType::window) ==
          Sides{"front", "front"});
    CHECK(sides(room_of("a hallway with a door on each side", seed), OpeningType::door) ==
          Sides{"left", "right"});
    CHECK(sides(room_of("a lounge with a window on every wall", seed), OpeningType::window) ==
          Sides{"back", "front", "left", "right"});
    CHECK(
        sides(room_of("a study with a door on the left wall and a window on the right wall", seed),
              OpeningType::door) == Sides{"left"});
  }
}

TEST_CASE("Opposite is the other side, beside is the same wall") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Room opposite =
        room_of("a bedroom with a window. The door is opposite the window.", seed);
    REQUIRE(count(opposite, OpeningType::window) == 1);
    REQUIRE(count(opposite, OpeningType::door) == 1);
    const Opening &a = *find_opening(opposite, "door-0"), &b = *find_opening(opposite, "window-0");
    CHECK(inward(opposite, a).dot(inward(opposite, b)) == Approx(-1.0));
    const Room beside = room_of("a bedroom with a round window next to the door", seed);
    CHECK(find_opening(beside, "door-0")->wall == find_opening(beside, "window-0")->wall);
    const auto two =
        sides(room_of("a living room with windows on two walls", seed), OpeningType::window);
    CHECK(std::set<std::string>(two.begin(), two.end()).size() == 2);
  }
}

TEST_CASE("Words choose the kind, and the kind its measures") {
  const auto only = [](const std::string& prompt, OpeningType type) {
    const Room room = room_of(prompt);
    INFO(prompt);
    REQUIRE(count(room, type) == 1);
    return *std::find_if(room.openings.begin(), room.openings.end(),
                         [&](const Opening& opening) { return opening.type == type; });
  };
  const Opening doubled = only("a dining room with double doors", OpeningType::door);
  CHECK(doubled.leaves == 2);
  CHECK(doubled.width() >= 1.1);
  const Opening sliding = only("a living room with a sliding glass door", OpeningType::door);
  CHECK(sliding.swing == DoorSwing::sliding);
  CHECK(sliding.glazed);
  CHECK(only("a bedroom with french doors", OpeningType::door).glazed);
  CHECK(only("a workshop with a garage door", OpeningType::door).width() > 2.0);
  const Opening arch = only("a living room with an open archway", OpeningType::passage);
  CHECK_FALSE(arch.outline.empty());
  const Room tall = room_of("a loft with a floor-to-ceiling window");
  REQUIRE(count(tall, OpeningType::window) == 1);
  for (const auto& opening : tall.openings)
    if (opening.type == OpeningType::window) {
      CHECK(opening.sill < 0.2);
      CHECK(opening.head > tall.height - 0.3);
    }
  CHECK_FALSE(only("a bathroom with a round window", OpeningType::window).outline.empty());
  CHECK(only("a bedroom with a 2 m wide window", OpeningType::window).width() == Approx(2.0));
  const Opening measured = only("a bedroom with a 1.2 by 1.5 m window", OpeningType::window);
  CHECK(measured.width() == Approx(1.2));
  CHECK(measured.head - measured.sill == Approx(1.5));
  CHECK(only("a bedroom with a small window", OpeningType::window).width() <
        only("a bedroom with a large window", OpeningType::window).width());
}

TEST_CASE("Numbers are kept where the walls allow it") {
  CHECK(count(room_of("a living room with five windows"), OpeningType::window) == 5);
  CHECK(count(room_of("a studio with three tall arched windows"), OpeningType::window,
              "arched window") == 3);
  CHECK(count(room_of("a hallway with three doors"), OpeningType::door) == 3);
  CHECK(count(room_of("a bedroom without windows"), OpeningType::window) == 0);
  CHECK(count(room_of("a bedroom with a window and two doors"), OpeningType::door) == 2);
  const Room mixed =
      room_of("an office with a double door on the front wall and two windows in the back wall");
  CHECK(count(mixed, OpeningType::door, "double door") == 1);
  CHECK(sides(mixed, OpeningType::window) == Sides{"back", "back"});
}

TEST_CASE("Doors of furniture, mats and seats are no doors and windows of the room") {
  for (const char* prompt :
       {"a bedroom with a wardrobe with sliding doors",
        "a kitchen with a cabinet with glass doors and drawers", "a hallway with a door mat",
        "a bedroom with a window seat", "a kitchen with a french door refrigerator",
        "a bedroom with a two-door wardrobe", "a desk by the window", "a sofa facing the door",
        "a plant to the left of the door", "a bed opposite the window"}) {
    INFO(prompt);
    CHECK(read_brief(prompt).openings.empty());
  }
  CHECK(read_brief("a bedroom with two large windows").windows == 2);
  CHECK(read_brief("a bedroom with two large windows").openings.empty());
}

TEST_CASE("What does not fit is made narrower, put elsewhere or left out, and a note says so") {
  for (const char* prompt : {"a 2 x 2 m hallway with twelve windows and three double doors",
                             "a 1.2 x 1 m hallway with a 3 m wide sliding door",
                             "a 3 x 3 m room with a 9 m wide window on the left wall",
                             "a 2 x 5 m hallway with a 3 m wide door on the front wall",
                             "a 0.6 x 0.6 m room with double doors",
                             "a 2 by 2 m storage room with ten doors on the left wall"}) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const Plan plan = test::plan_of(prompt, seed);
      INFO(prompt << ": " << join(plan.notes, "; "));
      CHECK(check(plan.room));
      CHECK(has_entrance(plan.room));
      CHECK_FALSE(plan.notes.empty());
    }
  }
}

TEST_CASE("Whatever is asked for, the room is sound, and equal questions have equal answers") {
  Random random(17);
  const std::vector<std::string> numbers = {"a", "two", "three", "several", "12", "the"};
  const std::vector<std::string> sizes = {"", "large", "tiny", "tall", "wide", "2.5 m"};
  const std::vector<std::string> places = {"",
                                           "on the left wall",
                                           "in the back wall",
                                           "on two walls",
                                           "on each side",
                                           "opposite the door",
                                           "opposite the window",
                                           "next to the door",
                                           "on the left and right walls",
                                           "on every wall",
                                           "to the left of the sofa"};
  std::vector<std::string> kinds;
  for (const auto& [name, kind] : OpeningKinds::built_in()->all()) kinds.push_back(name);
  for (int round = 0; round < 150; ++round) {
    std::string prompt = "a " + std::string(test::room_types[random.integer(0, 5)]);
    if (random.chance(0.4))
      prompt = format_number(random.uniform(1.0, 6.0), 1) + " x " +
               format_number(random.uniform(1.0, 6.0), 1) + " m " + prompt.substr(2);
    for (int n = random.integer(1, 4); n > 0; --n)
      prompt += (random.chance(0.5) ? " with " : " and ") + random.pick(numbers) + " " +
                random.pick(sizes) + " " + random.pick(kinds) + (random.chance(0.5) ? "s " : " ") +
                random.pick(places) + (random.chance(0.3) ? "." : "");
    const auto seed = static_cast<std::uint64_t>(round);
    const Brief brief = read_brief(prompt);
    const RoomKind& kind = built_in_room_kinds()->get(brief.type);
    Room room;
    room.height = random.uniform(1.6, 4.0);
    room.polygon = shapes::random_star(random, {0, 0}, 0.6, 4.0, random.integer(3, 9));
    if (!make_polygon(room.polygon.points)) continue;
    const Room bare = room;
    std::vector<std::string> notes;
    const RoomOpenings openings{random.integer(0, 3), random.chance(0.5), false, brief.openings};
    Random first(seed), second(seed);
    plan_openings(room, kind, {}, openings, first, notes);
    INFO(prompt << ": " << join(notes, "; "));
    const auto status = check(room);
    INFO((status ? "" : status.error().message));
    CHECK(status);
    Room again = bare;
    std::vector<std::string> same;
    plan_openings(again, kind, {}, openings, second, same);
    CHECK(to_json(again).dump() == to_json(room).dump());
    CHECK(same == notes);
    for (const auto& opening : room.openings) {
      CHECK(opening.from >= 0.0);
      CHECK(opening.to <= room.polygon.edge(opening.wall).length() + 1e-9);
    }
  }
}

TEST_CASE("Curtains hang at every window, a pair is one, a curtain is one") {
  const auto curtains = [](const std::string& prompt) {
    const Plan plan = test::plan_of(prompt, 1);
    return std::pair(test::count_of(plan, "curtain"), count(plan.room, OpeningType::window));
  };
  CHECK(curtains("a bedroom with three windows and curtains") == std::pair(3, 3));
  CHECK(curtains("a bedroom with one window and curtains") == std::pair(1, 1));
  CHECK(curtains("a bedroom with two windows and a curtain") == std::pair(1, 2));
  CHECK(curtains("a bedroom with two windows and a pair of curtains") == std::pair(1, 2));
}

TEST_CASE("Windows that nobody counted have a wall without another window, and doors do not cross") {
  Random random(23);
  for (int round = 0; round < 150; ++round) {
    Room room;
    room.polygon = shapes::random_star(random, {0, 0}, 2.0, 5.0, random.integer(3, 9));
    if (!make_polygon(room.polygon.points)) continue;
    const RoomKind& kind = built_in_room_kinds()->get(test::room_types[random.integer(0, 5)]);
    RoomOpenings openings;
    openings.windows = random.integer(0, 4);
    std::vector<std::string> notes;
    plan_openings(room, kind, {}, openings, random, notes);
    REQUIRE(check(room));
    CHECK(notes.empty());
    CHECK(has_entrance(room));
    CHECK(count(room, OpeningType::window) <= openings.windows);
    std::set<std::size_t> walls;
    for (const auto& opening : room.openings) CHECK(walls.insert(opening.wall).second);
  }
}

TEST_CASE("A floor plan without a door gets one beside its windows") {
  Room room;
  room.polygon.points = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  for (std::size_t wall = 0; wall < 4; ++wall) {
    Opening window;
    window.type = OpeningType::window;
    window.id = "window-" + std::to_string(wall);
    window.wall = wall;
    window.from = 0.4;
    window.to = 1.9;
    window.sill = 0.9;
    room.openings.push_back(window);
  }
  std::vector<std::string> notes;
  ensure_door(room, built_in_room_kinds()->any, notes);
  CHECK(check(room));
  REQUIRE(find_opening(room, "door-0"));
  CHECK(room.polygon.edge(find_opening(room, "door-0")->wall).length() == Approx(4.0));
  CHECK(notes.size() == 1);
  const Room with_door = room;
  ensure_door(room, built_in_room_kinds()->any, notes);
  CHECK(to_json(room) == to_json(with_door));
  CHECK(notes.size() == 1);
}
