#include "geometry/svg_path.h"

#include "catch.h"
#include "support/error_of.h"

using namespace roomgen;

namespace {

std::vector<SvgSubpath> subpaths(std::string_view path, const SvgPathOptions& options = {}) {
  const auto read = read_svg_path(path, options);
  INFO(path << ": " << (read ? "" : read.error().message));
  REQUIRE(read);
  return *read;
}

}  // namespace

TEST_CASE("Each M begins a subpath, and so does a line behind a Z, where that began") {
  const auto read = subpaths("M1,1 h2 v2 z l0,5 m1,1 M9,9");
  REQUIRE(read.size() == 4);
  CHECK(read[0].closed);
  CHECK(read[0].points == std::vector<Vec2>{{1, 1}, {3, 1}, {3, 3}});
  CHECK_FALSE(read[1].closed);
  CHECK(read[1].points == std::vector<Vec2>{{1, 1}, {1, 6}});
  CHECK(read[2].points == std::vector<Vec2>{{2, 7}});
  CHECK(read[3].points == std::vector<Vec2>{{9, 9}});
  CHECK(subpaths(" ").empty());
}

TEST_CASE("Arcs have lines of an angle or of a number, and their ellipse's own radii") {
  const std::string_view path = "M0,0 a4,2 0 0,1 8,0";
  CHECK(subpaths(path, {.curve_steps = 5}).front().points.size() == 1 + 5);
  const auto points = subpaths(path, {.curve_steps = 5, .arc_step = pi / 6}).front().points;
  REQUIRE(points.size() == 1 + 6);
  CHECK((points[3] - Vec2(4, -2)).norm() == Approx(0.0).margin(1e-9));
}

TEST_CASE("A path is read within its limits, and errors tell the byte") {
  const auto refusal = [](std::string_view path, const SvgPathOptions& options = {}) {
    return error_of(read_svg_path(path, options)).substr(0, 13);
  };
  CHECK(refusal("M0,0 h1 v1 z", {.most_points = 3, .most_subpaths = 1, .greatest = 1}) == "");
  CHECK(refusal("M0,0 h1 v1 h1", {.most_points = 3}) == "path, byte 13");
  CHECK(refusal("M0,0 h1 M5,5", {.most_subpaths = 1}) == "path, byte 9:");
  CHECK(refusal("M0,0 h1 z h1", {.most_subpaths = 1}) == "path, byte 11");
  CHECK(refusal("M0,0 h-2", {.greatest = 1}) == "path, byte 8:");
  CHECK(refusal("M0,0 L4") == "path, byte 7:");
  CHECK(refusal("M0,0 b4") == "path, byte 5:");
}
