#include "place_reply.h"

#include <cmath>
#include <limits>

#include "base/random.h"
#include "catch.h"
#include "support/contains.h"
#include "support/damaged.h"
#include "support/rooms.h"

using namespace roomgen;
using namespace roomgen::brief;
using namespace roomgen::design;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Case {
  const char* answer;
  const char* relations;  ///< as text
  double x, y;            ///< location; none if there is none
  double yaw;             ///< degrees; none if there is none
  bool repaired;
};

// 5 x 4 m: a bed and a desk, a coffee table, two chairs; nightstand-0 is to be placed.
Scene furnished() {
  Room room = rooms::box(5, 4);
  room.openings = {rooms::door("door-0", 0, 3.5, 4.4), rooms::window("window-0", 2, 1, 2.5)};
  return rooms::scene(room, {rooms::thing("bed-0", "bed", {1.6, 2, 0.9}, {1, 2.9}),
                             rooms::thing("desk-0", "desk", {1.4, 0.7, 0.75}, {4.5, 2}, 90),
                             rooms::thing("coffee table-0", "coffee table", {1, 0.6, 0.4}, {3, 2}),
                             rooms::thing("chair-0", "chair", {0.5, 0.5, 0.9}, {3.8, 2}),
                             rooms::thing("chair-1", "chair", {0.5, 0.5, 0.9}, {3, 3})});
}

const Object nightstand = rooms::thing("nightstand-0", "nightstand", {0.5, 0.4, 0.5});

void check(const Case& one, const PlaceReplyContext& context) {
  INFO(one.answer);
  const auto reply = read_place_reply(one.answer, context);
  REQUIRE(reply);
  std::string repairs;
  for (const auto& repair : reply->repairs) repairs += repair + "\n";
  INFO(repairs);
  CHECK(to_text(reply->advice.relations) == one.relations);
  REQUIRE(reply->advice.location.has_value() == !std::isnan(one.x));
  if (reply->advice.location) {
    CHECK(reply->advice.location->x() == Approx(one.x).margin(1e-9));
    CHECK(reply->advice.location->y() == Approx(one.y).margin(1e-9));
  }
  REQUIRE(reply->advice.yaw.has_value() == !std::isnan(one.yaw));
  if (reply->advice.yaw) CHECK(degrees(*reply->advice.yaw) == Approx(one.yaw).margin(1e-6));
  CHECK(!reply->repairs.empty() == one.repaired);
}

// An answer with these constraints and nothing else that is wrong.
std::string constrained(const std::string& constraints) {
  return R"({"reasoning": "r", "constraints": )" + constraints + R"(, "location": [1, 2]})";
}

std::string located(const std::string& location) {
  return R"({"reasoning": "r", "constraints": "edge", "location": )" + location + "}";
}

std::string facing(const std::string& where) {
  return R"({"constraints": "edge", "location": [1, 2], "facing": )" + where + "}";
}

}  // namespace

TEST_CASE("Well-formed answers are taken as they are") {
  const Scene scene = furnished();
  const PlaceReplyContext context{scene, nightstand};
  const auto reply = read_place_reply(
      R"({"reasoning": "Beside the bed.", "constraints": "edge | near, bed-0 | face to, desk-0",
          "location": [2.1, 3.7], "facing": 90})",
      context);
  REQUIRE(reply);
  CHECK(reply->advice.reasoning == "Beside the bed.");
  CHECK(to_text(reply->advice.relations) == "edge | near, bed-0 | face to, desk-0");
  CHECK(reply->advice.location->isApprox(Vec2(2.1, 3.7)));
  CHECK(*reply->advice.yaw == Approx(pi / 2));
  CHECK(reply->repairs.empty());
}

TEST_CASE("Constraints are understood however they are written") {
  struct Written {
    const char* constraints;
    const char* relations;
    bool repaired;
  };
  const Written cases[] = {
      {R"(["edge", "near, bed-0"])", "edge | near, bed-0", false},
      {R"([{"type": "near", "target": "bed-0"}, {"type": "edge"}])", "near, bed-0 | edge", false},
      {R"([{"constraint": "left of", "object": "bed-0"}])", "left of, bed-0", false},
      {R"([["near", "bed-0"], ["edge"]])", "near, bed-0 | edge", false},
      {R"({"near": "bed-0", "edge": true, "middle": false})", "near, bed-0 | edge", false},
      {R"({"near": ["bed-0", "desk-0"]})", "near, bed-0 | near, desk-0", false},
      {R"("nightstand-0 | edge | near, bed-0")", "edge | near, bed-0", false},
      {R"("Nightstand 0 | edge")", "edge", false},
      {R"("edge; near, bed-0")", "edge | near, bed-0", false},
      {R"("edge\nnear, bed-0")", "edge | near, bed-0", false},
      {R"("- edge\n- near, bed-0")", "edge | near, bed-0", false},
      {R"("1. edge\n2. near, bed-0")", "edge | near, bed-0", false},
      {R"("edge, near, bed-0, face to, desk-0")", "edge | near, bed-0 | face to, desk-0", false},
      {R"j("near(bed-0) | edge()")j", "near, bed-0 | edge", false},
      {R"("near: bed-0")", "near, bed-0", false},
      {R"("near bed-0")", "near, bed-0", false},
      {R"(["near", "bed-0"])", "near, bed-0", false},
      {R"("near bed-0 and desk-0")", "near, bed-0 | near, desk-0", false},
      {R"("EDGE | Near, BED-0")", "edge | near, bed-0", true},
      {R"("in_front_of, bed-0")", "in front of, bed-0", false},
      {R"("next to, bed-0")", "next to, bed-0", false},
      {R"("against the wall | near, bed-0")", "edge | near, bed-0", true},
      {R"("at the edge")", "edge", true},
      {R"("center_aligned, bed-0")", "center aligned, bed-0", false},
      {R"("center align with, bed-0")", "center aligned, bed-0", true},
      {R"("facing, desk-0")", "face to, desk-0", true},
      {R"("facing the desk-0")", "face to, desk-0", true},
      {R"("left, bed-0")", "left of, bed-0", true},
      {R"("to the left of the bed-0")", "left of, bed-0", true},
      {R"("beside bed-0")", "side of, bed-0", true},
      {R"("in the corner")", "corner", true},
      {R"("middle of the room")", "middle", true},
      {R"("center")", "middle", true},
      {R"("near, corner")", "near, corner", false},
      {R"("far, door-0 | near, window-0 | near, wall-2")",
       "far, door-0 | near, window-0 | near, wall-2", false},
      {R"("near, Coffee Table 0")", "near, coffee table-0", true},
      {R"("near, coffee_table-0")", "near, coffee table-0", true},
      {R"("near, the coffee table")", "near, coffee table-0", true},
      {R"("near, cofee table-0")", "near, coffee table-0", true},
      {R"("near, the window")", "near, window-0", true},
      {R"("edge | near, the chair")", "edge", true},
      {R"("edge | near, chair-3")", "edge", true},
      {R"("edge | near, wall-7")", "edge", true},
      {R"("edge | near, north wall")", "edge", true},
      {R"("edge | near, lamp-0")", "edge", true},
      {R"("edge | near, nightstand-0")", "edge", true},
      {R"("edge | cosy, bed-0")", "edge", true},
      {R"("edge | levitating")", "edge", true},
      {R"("neer, bed-0")", "near, bed-0", true},
      {R"("edge | middle | near, bed-0")", "edge | near, bed-0", true},
      {R"("middle | corner")", "middle", true},
      {R"("edge | edge | near, bed-0 | near, bed-0")", "edge | near, bed-0", true},
      {R"("edge | near")", "edge", true},
      {R"("edge, wall-0")", "edge | next to, wall-0", true},
      {R"([])", "", false},
      {R"(null)", "", false},
      {R"(42)", "", true},
  };
  const Scene scene = furnished();
  for (const auto& one : cases)
    check({constrained(one.constraints).c_str(), one.relations, 1, 2, none, one.repaired},
          {scene, nightstand});
}

TEST_CASE("Only twelve constraints are kept") {
  std::string text = "\"edge";
  for (const char* kind : {"near", "far", "around", "aligned"})
    for (const char* target : {"bed-0", "desk-0", "chair-0", "chair-1"})
      text += std::string(" | ") + kind + ", " + target;
  const Scene scene = furnished();
  const auto reply = read_place_reply(constrained(text + "\""), {scene, nightstand});
  REQUIRE(reply);
  CHECK(reply->advice.relations.size() == 12);
  CHECK(!reply->repairs.empty());
}

TEST_CASE("Locations are understood however they are written") {
  struct Written {
    const char* location;
    double x, y;
    bool repaired;
  };
  const Written cases[] = {
      {"[4, 1.5]", 4, 1.5, false},
      {R"({"x": 4, "y": 1.5})", 4, 1.5, false},
      {R"({"y": 1.5, "x": 4})", 4, 1.5, false},
      {R"("x: 4, y: 1.5")", 4, 1.5, false},
      {R"j("(4 m, 1.5 m)")j", 4, 1.5, false},
      {R"("4, 1.5")", 4, 1.5, false},
      {R"(["4.0", "1.5"])", 4, 1.5, false},
      {R"(["4 m", "150 cm"])", 4, 1.5, false},
      {R"(["4000 mm", "1500mm"])", 4, 1.5, false},
      {R"(["5 ft", "5'"])", 1.524, 1.524, false},
      {"[4, 1.5, 0]", 4, 1.5, false},
      {"[[4, 1.5]]", 4, 1.5, false},
      {"[400, 150]", 4, 1.5, true},
      {"[4000, 1500]", 4, 1.5, true},
      {"[3, 4.8]", 4.8, 3, true},
      {R"({"x": 3, "y": 4.8})", 3, 3.999, true},
      {"[5.4, 2]", 4.999, 2, true},
      {"[-0.5, 2]", 0.001, 2, true},
      {"[7.5, 7.5]", none, none, true},
      {"[NaN, 2]", none, none, true},
      {"[1e999, 2]", none, none, true},
      {R"(["left", 2, 3])", none, none, true},
      {R"("near the bed")", none, none, true},
      {R"("4.2 - 0.5, 2")", none, none, true},
      {"[2]", none, none, true},
      {"{}", none, none, true},
      {"null", none, none, true},
      {"true", none, none, true},
  };
  const Scene scene = furnished();
  for (const auto& one : cases)
    check({located(one.location).c_str(), "edge", one.x, one.y, none, one.repaired},
          {scene, nightstand});
}

TEST_CASE("Locations of the other frame are converted back") {
  Scene scene = furnished();
  for (auto& point : scene.room.polygon.points) point += Vec2(10, 20);
  // x from 10 to 15, y from 20 to 24: one down from the top, two left from the right.
  check({R"({"constraints": "edge", "location": [1, 2]})", "edge", 13, 23, none, false},
        {scene, nightstand, true});
  check({R"({"constraints": "edge", "location": [100, 200]})", "edge", 13, 23, none, true},
        {scene, nightstand, true});
}

TEST_CASE("Facing is understood however it is written") {
  struct Written {
    const char* facing;
    const char* relations;
    double yaw;
    bool repaired;
  };
  const Written cases[] = {
      {"90", "edge", 90, false},
      {"-450.0", "edge", -90, false},
      {R"("90 degrees")", "edge", 90, false},
      {R"("90°")", "edge", 90, false},
      {R"("north")", "edge", 180, false},
      {R"("South")", "edge", 0, false},
      {R"("east")", "edge", 90, false},
      {R"("north-west")", "edge", -135, false},
      {R"("coffee table-0")", "edge", 90, false},
      {R"("towards the coffee table")", "edge", 90, true},
      {R"("wall-1")", "edge", 90, false},
      {R"("wall-2")", "edge", 180, false},
      {R"("somewhere")", "edge", none, true},
      {R"("corner")", "edge | face to, corner", none, false},
      {"1e9", "edge", none, true},
      {"[1, 2]", "edge", none, true},
      {"null", "edge", none, false},
  };
  const Scene scene = furnished();
  for (const auto& one : cases)
    check({facing(one.facing).c_str(), one.relations, 1, 2, one.yaw, one.repaired},
          {scene, nightstand});
}

TEST_CASE("Whole answers of many kinds of models") {
  const Case cases[] = {
      {"Let's see.\n```json\n{\"Constraint\": \"edge\", \"Position\": [1, 2]}\n```", "edge", 1, 2,
       none, false},
      {R"({"constraints": "edge", "x": "1 m", "y": 2})", "edge", 1, 2, none, false},
      {R"({"placement": {"constraints": ["edge"], "location": [1, 2]}})", "edge", 1, 2, none,
       false},
      {R"({"nightstand-0": {"constraints": ["edge"], "location": [1, 2]}})", "edge", 1, 2, none,
       false},
      {"<think>hm { }</think>\n{constraints: 'edge | near, bed-0', location: (1, 2)}",
       "edge | near, bed-0", 1, 2, none, true},
      {R"({"location": [1, 2]})", "", 1, 2, none, false},
      {R"({"constraints": "edge"})", "edge", none, none, none, true},
      {R"({"constraints": "edge", "facing": "desk-0"})", "edge | face to, desk-0", none, none, none,
       true},
      {R"({"constraints": "face to, desk-0", "facing": "desk-0"})", "face to, desk-0", none, none,
       none, true},
      {R"({"constraints": "edge", "location": [1, 2], "facing": "desk-0")", "edge", 1, 2, 90, true},
  };
  const Scene scene = furnished();
  for (const auto& one : cases) check(one, {scene, nightstand});
}

TEST_CASE("An answer that helps in nothing says what was wrong") {
  const Scene scene = furnished();
  const auto problem = [&](const char* text) {
    INFO(text);
    const auto reply = read_place_reply(text, {scene, nightstand});
    REQUIRE(!reply);
    CHECK(reply.error().kind == Error::Kind::invalid_input);
    return reply.error().message;
  };
  CHECK(contains_text(problem("I am sorry."), "no JSON object"));
  CHECK(contains_text(problem(R"({"constraints": "near, lamp-0", "location": [40, -40]})"),
                      "\"lamp-0\" is not in the room"));
  CHECK(contains_text(problem(R"({"constraints": [], "location": [40, -30]})"), "[40, -30]"));
  CHECK(contains_text(problem(R"({"weather": "fine"})"), "nightstand-0"));
}

TEST_CASE("Damaged answers do no harm") {
  const std::vector<std::string> answers = {
      R"({"reasoning": "Beside the bed.", "constraints": "edge | near, bed-0 | face to, desk-0", "location": [2.1, 3.7], "facing": 90})",
      R"({"constraints": [{"type": "near", "target": "coffee table-0"}, "corner"], "location": {"x": "4 m", "y": 150}, "facing": "wall-2"})",
      "```json\n{'constraints': ['left of, bed-0', 'far, door-0'], 'location': (400, 150)}\n```",
      "<think>x</think>{constraints: {near: 'chair-1'}, location: \"x: 1.2, y: 3\", facing: "
      "north}"};
  const Scene scene = furnished();
  Random random(5);
  int understood = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::string text = damaged(random.pick(answers), random, 6);
    INFO(text);
    const auto reply = read_place_reply(text, {scene, nightstand, i % 2 == 0});
    if (!reply) continue;
    ++understood;
    const PlaceAdvice& advice = reply->advice;
    if (advice.location) REQUIRE(contains(scene.room.polygon, *advice.location));
    if (advice.yaw) REQUIRE(std::isfinite(*advice.yaw));
    REQUIRE(advice.relations.size() <= 12);
    for (const auto& relation : advice.relations) {
      REQUIRE(takes_target(relation.kind) == !relation.target.empty());
      if (relation.target.empty()) continue;
      const bool there = find_object(scene, relation.target) ||
                         find_opening(scene.room, relation.target) || relation.target == "corner" ||
                         contains_text("wall-0 wall-1 wall-2 wall-3", relation.target);
      REQUIRE(there);
    }
  }
  CHECK(understood > 1000);
}

TEST_CASE("What cannot be understood of an answer is told apart from what was repaired") {
  const Scene scene = furnished();
  const PlaceReplyContext context{scene, nightstand};
  const auto said = [&](const std::string& constraints, const std::string& facing) {
    const auto reply = read_place_reply(R"({"constraints": ")" + constraints +
                                            R"(", "location": [2, 2], "facing": )" + facing + "}",
                                        context);
    REQUIRE(reply);
    return reply->advice.lost;
  };
  CHECK(said("edge | near, Bed 0", "90").empty());
  CHECK(said("edge | near, throne-7", "90").size() == 1);
  CHECK(said("edge | hover", "90").size() == 1);
  CHECK(said("edge | middle", "90").size() == 1);
  CHECK(said("edge", R"("throne-7")").size() == 1);
  CHECK(said("edge", "null").empty());
}

TEST_CASE("A wall that things stand against and a window that they stand under are understood") {
  const Scene scene = furnished();
  const PlaceReplyContext context{scene, nightstand};
  const auto relations = [&](const std::string& constraints) {
    const auto reply = read_place_reply(
        R"({"location": [2, 2], "constraints": ")" + constraints + "\"}", context);
    REQUIRE(reply);
    CHECK(reply->advice.lost.empty());
    return to_text(reply->advice.relations);
  };
  CHECK(relations("against, wall-3") == "edge | next to, wall-3");
  CHECK(relations("on, wall-3 | near, bed-0") == "edge | next to, wall-3 | near, bed-0");
  CHECK(relations("under, window-0") == "near, window-0 | in front of, window-0");
}

TEST_CASE("A hundred moves are taken, and what is not taken is told with its reason") {
  const Scene scene = furnished();
  const PlaceReplyContext context{scene, nightstand};
  Json moves = {{{"id", "bed-0"}}, {{"location", {1, 1}}}, {{"id", "bed-0"}, {"location", "there"}}};
  for (int i = 0; i < 130; ++i)
    moves.push_back({{"id", "cup-" + std::to_string(i)}, {"location", {2.0, 2.0}}, {"facing", 90}});
  const Json answer = {{"constraints", "edge"}, {"location", {2, 2}}, {"move", moves}};
  const auto reply = read_place_reply(answer.dump(), context);
  REQUIRE(reply);
  CHECK(reply->advice.moves.size() == 97);
  CHECK(reply->advice.moves.front().object == "cup-0");
  const auto& lost = reply->advice.lost;
  REQUIRE(lost.size() == 4);
  CHECK(contains_text(lost[0], "needs an id and a location"));
  CHECK(contains_text(lost[1], "needs an id and a location"));
  CHECK(contains_text(lost[2], "the location is not two numbers"));
  CHECK(contains_text(lost[3], "only the first 100 of 133 moves"));
}
