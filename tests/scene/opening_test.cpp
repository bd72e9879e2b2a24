// What an opening is beyond its rectangle: outline, leaves, kind and mesh; and how files hold them.
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/random.h"
#include "catch.h"
#include "geometry/outline.h"
#include "roomgen/base/json.h"
#include "scene/document_parts.h"
#include "scene/opening_kind.h"
#include "support/contains.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

Opening arched_window(std::size_t wall) {
  Opening window = rooms::window("window-0", wall, 1.0, 2.0);
  window.kind = "arched window";
  window.outline = {{0, 0}, {1, 0}, {1, 0.6}, {0.7, 1}, {0.2, 0.9}, {0, 0.5}};
  window.joinery.asset = {"Library", "arched", "12ab", "CC0", "somebody", std::nullopt};
  window.joinery.wall_front = 0.03;
  window.joinery.wall_back = 0.21;
  window.joinery.mirrored = true;
  window.joinery.side_by_side = 2;
  return window;
}

Result<Room> read(const std::string& text) {
  auto json = parse_json(text, "room.json");
  REQUIRE(json);
  JsonReader::Problems problems("room.json");
  Room room = read_room(JsonReader(*json, problems));
  if (problems.first()) return *problems.first();
  return room;
}

std::string room_with(const std::string& opening) {
  return R"({"polygon":[[0,0],[4,0],[4,3],[0,3]],"openings":[)" + opening + "]}";
}

}  // namespace

TEST_CASE("A file holds all that an opening is") {
  Room room = rooms::box(4, 3);
  Opening door = rooms::door("door-0", 0, 0.5, 2.1);
  door.kind = "french door";
  door.leaves = 2;
  door.glazed = true;
  room.openings = {door, arched_window(2)};
  REQUIRE(check(room));
  const auto again = read(to_json(room).dump());
  REQUIRE(again);
  CHECK(to_json(*again).dump() == to_json(room).dump());
  CHECK(again->openings[0].leaves == 2);
  CHECK(again->openings[0].glazed);
  CHECK(again->openings[0].joinery.asset.is_box());
  const Opening& window = again->openings[1];
  CHECK(window.kind == "arched window");
  CHECK(window.outline.size() == 6);
  CHECK(window.joinery.asset == room.openings[1].joinery.asset);
  CHECK(window.joinery.wall_back == 0.21);
  CHECK(window.joinery.mirrored);
  CHECK(window.joinery.side_by_side == 2);
}

TEST_CASE("A file that says nothing of outline, leaves and mesh has a plain opening") {
  const auto room = read(room_with(R"({"id":"door-0","type":"door","wall":0,"from":1,"to":2})"));
  REQUIRE(room);
  const Opening& door = room->openings[0];
  CHECK(door.leaves == 1);
  CHECK(door.outline.empty());
  CHECK(door.kind.empty());
  CHECK(to_json(*room).dump().find("outline") == std::string::npos);
  CHECK(to_json(*room).dump().find("asset") == std::string::npos);
}

TEST_CASE("A clockwise floor plan turns outlines and hinges with its walls") {
  // Wall 2 of the clockwise plan is the same wall, run through the other way.
  const auto room = read(
      R"({"polygon":[[0,0],[0,3],[4,3],[4,0]],"openings":[{"id":"window-0","type":"window","wall":1,
          "from":1,"to":2,"outline":[[0,0],[1,0],[1,1]]}]})");
  REQUIRE(room);
  const Opening& window = room->openings[0];
  const Segment line = segment(*room, window);
  // The upright side was at x = 2, where the file's wall ends.
  double upright = -1.0;
  for (const auto& p : outline(window))
    if (p.y() == Approx(window.head))
      upright =
          (room->polygon.edge(window.wall).a + p.x() * room->polygon.edge(window.wall).direction())
              .x();
  CHECK(upright == Approx(2.0));
  CHECK(std::min(line.a.x(), line.b.x()) == Approx(1.0));
  CHECK(signed_area(window.outline) > 0);
}

TEST_CASE("Outlines that no hole can have are refused with their opening's name") {
  for (const char* outline : {"[[0,0],[1,0]]", "[[0,0],[1,0],[1,0.1]]",
                              "[[0,0],[1,0],[1,1],[0.4,0.2],[0.6,0.9],[0,1]]",
                              "[[0,0],[1,0],[0.2,0.5],[1,1],[0,1]]", "[[0,0],[1,1],[1,0],[0,1]]"}) {
    const auto room = read(room_with(
        std::string(R"({"id":"window-7","type":"window","wall":0,"from":1,"to":2,"outline":)") +
        outline + "}"));
    INFO(outline);
    REQUIRE_FALSE(room);
    CHECK(room.error().message.find("window-7") != std::string::npos);
  }
  for (const char* wrong :
       {R"("outline":[[0,0],[2,0],[1,1]])", R"("leaves":3)", R"("in_wall":[0.2,0.1])",
        R"("side_by_side":0)", R"("outline":"round")", R"("mesh":1)"}) {
    const auto room = read(
        room_with(std::string(R"({"id":"window-7","type":"window","wall":0,"from":1,"to":2,)") +
                  wrong + "}"));
    INFO(wrong);
    REQUIRE_FALSE(room);
    CHECK(room.error().message.find("/openings/0") != std::string::npos);
  }
}

TEST_CASE("Random polygons are outlines just when every upright line crosses them once") {
  Random random(11);
  int yes = 0, no = 0;
  for (int round = 0; round < 2000; ++round) {
    std::vector<Vec2> points;
    for (int n = random.integer(3, 6); n > 0; --n)
      points.emplace_back(random.uniform(), random.uniform());
    const auto polygon = make_polygon(points);
    if (!polygon || area(*polygon) < 0.2) continue;
    // Counted line by line: in and out once.
    int most = 0;
    for (int i = 1; i < 400; ++i) {
      const double x = i / 400.0 + 1e-5;
      int crossings = 0;
      for (std::size_t k = 0; k < polygon->size(); ++k) {
        const Segment e = polygon->edge(k);
        crossings += (e.a.x() < x) != (e.b.x() < x);
      }
      most = std::max(most, crossings);
    }
    const bool expected = most <= 2;
    if (is_opening_outline(polygon->points) != expected) {
      // Only a fold thinner than the lines may escape the count.
      CHECK(expected);
      continue;
    }
    (expected ? yes : no) += 1;
  }
  CHECK(yes > 50);
  CHECK(no > 25);
}

TEST_CASE("The kinds of openings are sound, and each is found by its names") {
  const auto& kinds = OpeningKinds::built_in();
  INFO((kinds ? "" : kinds.error().message));
  REQUIRE(kinds);
  for (const auto type : {OpeningType::door, OpeningType::window, OpeningType::passage})
    REQUIRE(kinds->find(name(type)));
  for (const auto& [name, kind] : kinds->all()) {
    INFO(name);
    CHECK(kinds->find(name) == &kind);
    CHECK(kinds->find(name + "s") == &kind);
    for (const auto& other : kind.names) CHECK(kinds->find(other) == &kind);
    if (!kind.outline.empty()) CHECK(is_opening_outline(kind.outline));
    if (kind.width) CHECK(*kind.width >= kind.least_width);
    if (kind.head && kind.sill) CHECK(*kind.head > *kind.sill + 0.2);
    if (kind.type != OpeningType::window) CHECK(kind.sill.value_or(0.0) == 0.0);
  }
}

TEST_CASE("A broken file of kinds is refused where it is broken") {
  const auto refused = [](const char* text, const char* where) {
    const auto kinds = OpeningKinds::parse(text, "openings.json");
    INFO(text);
    REQUIRE_FALSE(kinds);
    INFO(kinds.error().message);
    CHECK(kinds.error().message.find(where) != std::string::npos);
  };
  refused(R"({"kinds":{"a":{"is":"b"}}})", "/kinds/a/is");
  refused(R"({"kinds":{"a":{"type":"hole"}}})", "/kinds/a/type");
  refused(R"({"kinds":{"a":{"swing":"up"}}})", "/kinds/a/swing");
  refused(R"({"kinds":{"a":{"outline":"M0,0 h1"}}})", "/kinds/a/outline");
  refused(R"({"kinds":{"a":{"names":["c"]},"b":{"names":["c"]}}})", "/kinds/b/names");
  refused(R"({"kinds":{"a":{"colour":"red"}}})", "/kinds/a");
}

TEST_CASE("Cut-out shapes are turned upright, the whole square is none") {
  const auto whole = outline_of_cut_out("M0,0 v1 h1 v-1 z");
  REQUIRE(whole);
  CHECK(whole->empty());
  const auto arch = outline_of_cut_out("M0,0.25 a0.5,0.25 0 0,1 1,0 v0.75 h-1 z");
  REQUIRE(arch);
  CHECK(is_opening_outline(*arch));
  double top = 0.0;
  for (const auto& p : *arch)
    if (std::abs(p.x() - 0.5) < 1e-6) top = std::max(top, p.y());
  CHECK(top == Approx(1.0));
  CHECK_FALSE(outline_of_cut_out("M0,0 h0.1 v1 h-0.1 z"));
}
