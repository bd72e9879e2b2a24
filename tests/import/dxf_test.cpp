#include "catch.h"
#include "roomgen/base/file.h"
#include "roomgen/import/import.h"
#include "support/contains.h"
#include "support/error_of.h"

using namespace roomgen;

namespace {

const std::string dxf_files = ROOMGEN_TEST_DATA "/floor-plans/";

// The entities of a drawing in metres.
std::string dxf(const std::string& entities, int units = 6) {
  return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + std::to_string(units) +
         "\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

std::string line(double ax, double ay, double bx, double by, const std::string& layer = "0") {
  return "0\nLINE\n8\n" + layer + "\n10\n" + std::to_string(ax) + "\n20\n" + std::to_string(ay) +
         "\n11\n" + std::to_string(bx) + "\n21\n" + std::to_string(by) + "\n";
}

std::string refusal_of_dxf(const std::string& text) {
  return error_of(room_from_dxf(text, "plan.dxf"));
}

}  // namespace

TEST_CASE("A polyline with a bulge is a room with a rounded end, wherever it is drawn") {
  const auto room = read_floor_plan(dxf_files + "round-end.dxf");
  REQUIRE(room);
  CHECK(check(*room));
  CHECK(bounds(room->polygon).low.norm() == Approx(0.0).margin(1e-6));
  CHECK(bounds(room->polygon).size().x() == Approx(5.5));
  CHECK(area(room->polygon) == Approx(12.0 + 0.5 * pi * 1.5 * 1.5).epsilon(0.01));
  // The door's swing is drawn on its layer too, and furniture on its own.
  REQUIRE(room->openings.size() == 2);
  CHECK(find_opening(*room, "door-0")->width() == Approx(0.9));
  CHECK(segment(*room, *find_opening(*room, "window-0")).middle().x() == Approx(0.0).margin(1e-6));
}

TEST_CASE("Lines in any order and direction close to an outline") {
  const auto room = read_floor_plan(dxf_files + "lines-r12.dxf");
  REQUIRE(room);
  CHECK(room->polygon.size() == 6);
  constexpr double foot = 0.3048;
  CHECK(area(room->polygon) == Approx((14 * 12 - 5 * 6) * foot * foot));
  CHECK(find_opening(*room, "door-0")->width() == Approx(3 * foot));
  CHECK(room->openings.size() == 2);
}

TEST_CASE("A polyline of the old kind, without units, is in metres") {
  const auto room = read_floor_plan(dxf_files + "polyline-r12.dxf");
  REQUIRE(room);
  CHECK(room->polygon.size() == 4);
  CHECK(area(room->polygon) == Approx(0.5 * (4.5 + 3.0) * 3.4));
}

TEST_CASE("Units of a DXF") {
  const auto side = [&](int units, double length) {
    const auto room = room_from_dxf(dxf(line(0, 0, length, 0) + line(length, 0, length, length) +
                                            line(length, length, 0, length) + line(0, length, 0, 0),
                                        units),
                                    "plan.dxf");
    return room ? bounds(room->polygon).size().x() : 0.0;
  };
  CHECK(side(4, 4000) == Approx(4.0));
  CHECK(side(5, 400) == Approx(4.0));
  CHECK(side(6, 4) == Approx(4.0));
  CHECK(side(1, 160) == Approx(4.064));
  CHECK(side(2, 13) == Approx(3.9624));
  CHECK(side(7, 4) == 0.0);     // kilometres
  CHECK(side(6, 4000) == 0.0);  // metres of what are millimetres
}

TEST_CASE("What is wrong with a DXF is told with its line and the way out") {
  const std::string open = dxf(line(0, 0, 4, 0) + line(4, 0, 4, 3) + line(4, 3, 0, 3));
  CHECK(contains_text(refusal_of_dxf(open), "the outline is open: it ends at (0, 3)"));
  CHECK(contains_text(refusal_of_dxf(dxf(line(0, 0, 3000, 0) + line(3000, 0, 3000, 4000) + line(3000, 4000, 0, 0))),
                      "$INSUNITS"));
  CHECK(contains_text(refusal_of_dxf(dxf("")), "draws no outline"));
  CHECK(contains_text(refusal_of_dxf("0\nSECTION\nx\n"), "plan.dxf:3: expected the number of a group"));
  CHECK(contains_text(refusal_of_dxf("0\nSECTION\n2"), "plan.dxf:3: the file ends within a group"));
  CHECK(contains_text(refusal_of_dxf(dxf("0\nLINE\n8\n0\n10\nabc\n")), "plan.dxf:20: \"abc\" is no coordinate"));
  CHECK(contains_text(refusal_of_dxf("AutoCAD Binary DXF\r\n\x1a"), "save it as ASCII"));
}
