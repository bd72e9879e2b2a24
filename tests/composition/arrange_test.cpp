// Compositions: what their patterns give, computed another way, and that all of data/compositions
// can be made.
#include "catch.h"
#include "composition/arrange.h"
#include "roomgen/base/json.h"

#include <nlohmann/json.hpp>

using namespace roomgen;
using namespace roomgen::composition;

namespace {

const KindTable& kinds() {
  return KindTable::built_in();
}

Result<Arranged> arranged(const std::string& json, const Values& values = {}) {
  const auto parsed = parse_json(json, "test");
  REQUIRE(parsed);
  const auto composition = read_composition(*parsed, "test", "test");
  if (!composition) return composition.error();
  return arrange(*composition, values, {*built_in_compositions(), kinds()});
}

std::vector<const Member*> of_part(const Arranged& all, const std::string& part) {
  std::vector<const Member*> found;
  for (const auto& member : all.members)
    if (member.part == part) found.push_back(&member);
  return found;
}

}  // namespace

TEST_CASE(
    "Every composition can be made at its usual, least and greatest values, with its anchor at the "
    "origin") {
  REQUIRE(built_in_compositions());
  CHECK(built_in_compositions()->size() > 200);
  for (const auto& [name, composition] : *built_in_compositions()) {
    INFO(name);
    CHECK_FALSE(composition.source.empty());
    CHECK_FALSE(composition.uses.empty());
    std::vector<Values> all = {{}};
    for (const auto& parameter : composition.parameters)
      if (parameter.choices.empty()) {
        all.push_back({{parameter.name, parameter.least}});
        all.push_back({{parameter.name, parameter.most}});
      }
    for (const auto& values : all) {
      const auto made = arrange(composition, values, {*built_in_compositions(), kinds()});
      if (!made) INFO(made.error().message);
      REQUIRE(made);
      REQUIRE_FALSE(made->members.empty());
      CHECK(made->members.front().place.position.norm() < 1e-9);
      CHECK(std::abs(made->members.front().place.yaw) < 1e-9);
      for (std::size_t i = 0; i < made->members.size(); ++i) {
        const Member& member = made->members[i];
        CHECK(member.place.position.allFinite());
        CHECK(kinds().find(member.category));
        if (member.mount == Mount::surface) CHECK(member.on < i);
      }
    }
  }
}

TEST_CASE("Seats around a table face it from its edges, evenly") {
  const std::string table =
      R"({"parameters": {"seats": {"default": 6, "least": 1, "most": 12}}, "parts": [
      {"part": "table", "kind": "dining table", "size": [1.8, 0.9, 0.75]},
      {"part": "chair", "kind": "dining chair", "size": [0.46, 0.52, 0.9], "around": "table", "count": "seats", "gap": -0.1}]})";
  for (double seats = 1; seats <= 12; ++seats) {
    const auto made = arranged(table, {{"seats", seats}});
    REQUIRE(made);
    const auto chairs = of_part(*made, "chair");
    REQUIRE(chairs.size() == static_cast<std::size_t>(seats));
    std::map<int, std::vector<double>> along;  // by side
    for (const auto* chair : chairs) {
      const Vec2 at = chair->place.position, front = rotated({0, -1}, chair->place.yaw);
      const bool at_end = std::abs(front.x()) > 0.5;
      // The front of the seat is 0.1 m under the edge.
      const double edge = at_end ? 0.9 : 0.45;
      const double off = at_end ? std::abs(at.x()) : std::abs(at.y());
      CHECK(off == Approx(edge + 0.26 - 0.1));
      CHECK(front.dot(at) < 0.0);
      along[at_end ? (at.x() > 0 ? 1 : 2) : (at.y() > 0 ? 3 : 4)].push_back(at_end ? at.y()
                                                                                   : at.x());
    }
    for (auto& [side, places] : along) {
      std::sort(places.begin(), places.end());
      const double length = side <= 2 ? 0.9 : 1.8,
                   pitch = length / static_cast<double>(places.size());
      for (std::size_t i = 0; i < places.size(); ++i)
        CHECK(places[i] ==
              Approx((static_cast<double>(i) + 0.5) * pitch - 0.5 * length).margin(1e-9));
    }
  }
}

TEST_CASE("Rows, arcs and things beside others stand where they are said to") {
  const auto rows = arranged(R"({"parts": [{"kind": "chair", "repeat":
      {"rows": 2, "columns": 3, "number": 5, "across": 0.7, "along": 1.1, "stagger": 0.35}}]})");
  REQUIRE(rows);
  REQUIRE(rows->members.size() == 5);
  CHECK(rows->members[4].place.position.isApprox(Vec2(0.7 + 0.35, 1.1)));

  const auto arc = arranged(R"({"parts": [{"kind": "fireplace", "size": [0.5, 0.5, 1]},
      {"part": "seat", "kind": "armchair", "of": "fireplace", "repeat": {"number": 5, "radius": 2, "from": 180, "to": 360}}]})");
  REQUIRE(arc);
  for (const auto* seat : of_part(*arc, "seat")) {
    CHECK(seat->place.position.norm() == Approx(2.0));
    CHECK(seat->place.position.y() < 1e-9);
    CHECK(rotated({0, -1}, seat->place.yaw).isApprox(Vec2(-seat->place.position / 2.0), 1e-9));
  }

  const auto bed = arranged(R"({"parts": [{"kind": "bed", "size": [1.6, 2.0, 0.9]},
      {"part": "stand", "kind": "nightstand", "size": [0.4, 0.3, 0.5], "beside": "bed", "side": "sides", "align": "back", "gap": 0.05},
      {"part": "lamp", "kind": "table lamp", "on": "stand"}]})");
  REQUIRE(bed);
  const auto stands = of_part(*bed, "stand");
  REQUIRE(stands.size() == 2);
  CHECK(stands[0]->place.position.isApprox(Vec2(0.8 + 0.05 + 0.2, 1.0 - 0.15)));
  CHECK(stands[1]->place.position.isApprox(Vec2(-1.05, 0.85)));
  CHECK(of_part(*bed, "lamp").size() == 2);
  CHECK(bed->members[of_part(*bed, "lamp")[1]->on].part == "stand");
  const Arranged other = mirrored(*bed);
  CHECK(other.members[1].place.position.isApprox(Vec2(-1.05, 0.85)));
}

TEST_CASE("What is before a sitter is before each one's own desk, a screen behind a keyboard") {
  const auto desks = arranged(R"({"parts": [
      {"part": "desk", "kind": "desk", "size": [1.4, 0.75, 0.72],
       "repeat": {"rows": 1, "columns": 4, "across": 1.45}},
      {"part": "chair", "kind": "office chair", "size": [0.6, 0.6, 1], "beside": "desk", "side": "front",
       "count": 1, "gap": -0.2, "facing": "to"},
      {"part": "monitor", "kind": "monitor", "size": [0.54, 0.18, 0.44], "on": "desk", "before": "chair"},
      {"part": "keyboard", "kind": "keyboard", "size": [0.44, 0.14, 0.03], "on": "desk", "before": "chair"}]})");
  REQUIRE(desks);
  const auto carriers = of_part(*desks, "desk"), monitors = of_part(*desks, "monitor"),
             keyboards = of_part(*desks, "keyboard");
  REQUIRE(monitors.size() == 4);
  REQUIRE(keyboards.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 desk = carriers[i]->place.position, screen = monitors[i]->place.position - desk,
               keys = keyboards[i]->place.position - desk;
    CHECK(&desks->members[monitors[i]->on] == carriers[i]);
    CHECK(&desks->members[keyboards[i]->on] == carriers[i]);
    CHECK(std::abs(screen.x()) < 1e-6);
    CHECK(std::abs(keys.x()) < 1e-6);
    CHECK(screen.y() - 0.09 > keys.y() + 0.07);  // apart, whoever sits at the front
    CHECK(screen.y() + 0.09 <= 0.375);
  }
}

TEST_CASE("A block falls into its units, each in the frame of its own anchor") {
  const auto block = arranged(R"({"parts": [{"part": "unit", "group": "desk with chair",
      "repeat": {"rows": 2, "columns": 2, "number": 4, "across": 2.0, "along": 2.0}}]})");
  REQUIRE(block);
  const auto units = units_of(*block);
  REQUIRE(units.size() == 4);
  const auto alone = arrange(built_in_compositions()->at("desk with chair"), {},
                             {*built_in_compositions(), kinds()});
  REQUIRE(alone);
  for (const auto& unit : units) {
    REQUIRE(unit.members.size() == alone->members.size());
    for (std::size_t i = 0; i < unit.members.size(); ++i)
      CHECK((unit.members[i].place.position - alone->members[i].place.position).norm() < 1e-9);
  }
}

TEST_CASE("Each copy of an anchor falls apart with what is at it") {
  const auto block = arranged(R"({"parts": [
      {"part": "table", "kind": "dining table", "repeat": {"columns": 3, "number": 3, "across": 3.0}},
      {"part": "chair", "kind": "dining chair", "around": "table", "count": 4}]})");
  REQUIRE(block);
  const auto units = units_of(*block);
  REQUIRE(units.size() == 3);
  for (const auto& unit : units) {
    REQUIRE(unit.members.size() == 5);
    CHECK(unit.members.front().part == "table");
    for (const auto* chair : of_part(unit, "chair")) CHECK(chair->place.position.norm() < 1.5);
  }
}

TEST_CASE("What a group may lose goes in its order, and what it may be is tried before") {
  const auto parsed = parse_json(
      R"({"mirrors": true, "parameters": {"seats": {"default": 4, "least": 2, "most": 8, "shrinks": true}},
      "parts": [{"part": "table", "kind": "dining table"},
        {"part": "chair", "kind": "dining chair", "around": "table", "count": "seats"},
        {"part": "lamp", "kind": "floor lamp", "beside": "table", "side": "left", "gap": 1, "spare": 1},
        {"part": "plant", "kind": "plant", "beside": "table", "side": "right", "gap": 1, "spare": 2}]})",
      "test");
  const auto composition = read_composition(*parsed, "test", "test");
  REQUIRE(composition);
  const auto ways = alternatives(*composition, {}, {}, {*built_in_compositions(), kinds()});
  REQUIRE(ways);
  const auto has = [](const Arranged& way, const std::string& part) {
    return !of_part(way, part).empty();
  };
  bool lost_lamp = false, lost_plant = false;
  std::size_t seats = 4;
  for (const auto& way : *ways) {
    if (!has(way, "plant")) lost_plant = true;
    if (!has(way, "lamp")) lost_lamp = true;
    if (lost_plant && seats == 4) CHECK(lost_lamp);
    const std::size_t now = of_part(way, "chair").size();
    CHECK(now <= seats);
    seats = now;
  }
  CHECK(seats == 2);
  CHECK(ways->size() <= most_alternatives);
  const auto kept = alternatives(*composition, {}, {"seats"}, {*built_in_compositions(), kinds()});
  REQUIRE(kept);
  for (const auto& way : *kept) CHECK(of_part(way, "chair").size() == 4);
}

TEST_CASE("What cannot be a composition is told with its place") {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {R"({"parts": []})", "anchor"},
      {R"({"parts": [{"kind": "table"}, {"kind": "chair", "around": "desk"}]})",
       "no part before it"},
      {R"({"parts": [{"kind": "table"}, {"part": "a", "kind": "chair", "around": "b"}, {"part": "b", "kind": "chair", "around": "a"}]})",
       "no part before it"},
      {R"({"parts": [{"kind": "table"}, {"kind": "chair"}]})", "does not say where it is"},
      {R"({"parts": [{"kind": "table"}, {"kind": "chair", "around": "table", "count": "seats"}]})",
       "seats"},
      {R"({"parts": [{"kind": "table", "size": ["1 +", 1, 1]}]})", "/parts/0/size/0"},
      {R"({"parts": [{"kind": "table", "colour": "red"}]})", "colour"},
      {R"({"parts": [{"group": "no such thing"}]})", "no such thing"},
      {R"({"parts": [{"kind": "table", "repeat": {"rows": 20, "columns": 30}}]})", "at most 400"},
  };
  for (const auto& [json, message] : wrong) {
    INFO(json);
    const auto made = arranged(json);
    REQUIRE_FALSE(made);
    CHECK(made.error().message.find(message) != std::string::npos);
  }
}
