#include "catch.h"
#include "roomgen/base/file.h"
#include "roomgen/scene/scene.h"
#include "support/contains.h"
#include "support/temporary_folder.h"

using namespace roomgen;

namespace {

std::string room_complaint(const std::string& text) {
  const TemporaryFolder folder;
  REQUIRE(write_file(folder / "room.json", text));
  const auto room = read_room_file(folder / "room.json");
  if (room) return "";
  CHECK(is_one_line(room.error().message));
  CHECK(contains_text(room.error().message, "room.json: "));
  return room.error().message;
}

std::string with_opening(const std::string& opening,
                         const std::string& polygon = "[[0,0],[4,0],[4,3],[0,3]]") {
  return room_complaint("{\"polygon\": " + polygon + ", \"openings\": [" + opening + "]}");
}

}  // namespace

TEST_CASE("A sound room is read") {
  CHECK(room_complaint(R"({"polygon": [[0,0],[4,0],[4,3],[0,3]]})").empty());
  CHECK(with_opening(R"({"id": "door-0", "wall": 0, "from": 0, "to": 4})").empty());
}

TEST_CASE("Each mistake in a room gives one located line") {
  CHECK(contains_text(room_complaint("{}"), "/polygon: missing"));
  CHECK(contains_text(room_complaint(R"({"polygon": [[0,0],[4,0]]})"), "/polygon: polygon: "));
  CHECK(contains_text(room_complaint(R"({"polygon": [[0,0],[4,0],[0,4],[5,6]]})"), "crosses"));
  CHECK(contains_text(room_complaint(R"({"polygon": [[0,0],[4,0],[4]]})"), "/polygon/2"));
  CHECK(contains_text(room_complaint(R"({"polygon": [[0,0],[4,0],[4,3],[0,3]], "height": 0.5})"), "/height"));
  CHECK(contains_text(room_complaint(R"({"polygon": [[0,0],[4,0],[4,3],[0,3]], "hight": 3})"),
                      "did you mean \"height\"?"));
}

TEST_CASE("Each mistake in an opening gives one located line") {
  CHECK(contains_text(with_opening(R"({"wall": 0, "from": 1, "to": 2})"), "/openings/0/id"));
  CHECK(contains_text(with_opening(R"({"id": "d", "wall": 4, "from": 1, "to": 2})"), "wall 4"));
  CHECK(contains_text(with_opening(R"({"id": "d", "wall": -1, "from": 1, "to": 2})"), "/openings/0/wall"));
  CHECK_FALSE(with_opening(R"({"id": "d", "wall": 0, "from": 3.5, "to": 4.4})").empty());
  CHECK_FALSE(with_opening(R"({"id": "d", "wall": 0, "from": 2, "to": 2.05})").empty());
  CHECK_FALSE(with_opening(R"({"id": "d", "wall": 0, "from": 1, "to": 2, "head": 2.8})").empty());
  CHECK_FALSE(with_opening(R"({"id": "d", "wall": 0, "from": 1, "to": 2, "sill": 2.5})").empty());
  CHECK(contains_text(with_opening(R"({"id": "d", "wall": 0, "from": 1, "to": 2, "type": "hole"})"),
                      "none of door, window, passage"));
  CHECK(contains_text(with_opening(R"({"id": "d", "wall": 0, "from": 1, "to": 2, "swing": "up"})"),
                      "none of in, out, sliding"));
  CHECK(contains_text(with_opening(R"({"id": "d", "wall": 0, "from": 1, "to": 2, "hinge": "left"})"),
                      "\"from\" or \"to\""));
  CHECK(contains_text(with_opening(R"({"id": "a", "wall": 0, "from": 1, "to": 2},
                                      {"id": "b", "wall": 0, "from": 1.5, "to": 2.5})"),
                      "overlaps \"a\""));
  CHECK(contains_text(with_opening(R"({"id": "a", "wall": 0, "from": 1, "to": 2},
                                      {"id": "a", "wall": 1, "from": 1, "to": 2})"),
                      "two of this id"));
}

TEST_CASE("An opening beyond its wall's end is refused, in either winding") {
  //   The wall that is numbered 0 here is 2 m long; the one opposite, 6 m.
  //     +--0--+
  //    3       1
  //   +----2----+
  const std::string clockwise = "[[2,3],[4,3],[6,0],[0,0]]";
  CHECK_FALSE(with_opening(R"({"id": "d", "wall": 0, "from": 1.5, "to": 2.4})", clockwise).empty());
  CHECK_FALSE(with_opening(R"({"id": "d", "wall": 0, "from": 4, "to": 5})", clockwise).empty());
  CHECK(with_opening(R"({"id": "d", "wall": 0, "from": 0.5, "to": 1.4})", clockwise).empty());
}
