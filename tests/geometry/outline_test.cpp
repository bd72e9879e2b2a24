#include "geometry/outline.h"

#include <cmath>

#include "base/random.h"
#include "catch.h"
#include "roomgen/geometry/polygon.h"

using namespace roomgen;

namespace {

std::vector<Vec2> outline(std::string_view path, int steps = 16) {
  const auto points = outline_of_path(path, steps);
  INFO(path << ": " << (points ? "" : points.error().message));
  REQUIRE(points);
  return *points;
}

bool same(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if ((a[i] - b[i]).norm() > 1e-9) return false;
  return true;
}

}  // namespace

TEST_CASE("Arcs are parts of their ellipse, whichever way they go") {
  for (const char* path :
       {"M0,1 a2,1 0 0,1 4,0 a2,1 0 0,1 -4,0 z", "M4 1A2 1 0 0 0 0 1A2 1 0 1 0 4 1Z",
        "m2,0a1,2 90 1,1 0,2a1,2 90 110-2z"}) {
    const auto points = outline(path, 40);
    for (const auto& p : points)
      CHECK(std::pow((p.x() - 2.0) / 2.0, 2) + std::pow(p.y() - 1.0, 2) == Approx(1.0));
    // A polygon of n corners in an ellipse: n/2 sin(2 pi / n) a b.
    const double n = static_cast<double>(points.size());
    CHECK(std::abs(signed_area(points)) == Approx(0.5 * n * std::sin(2 * pi / n) * 2.0));
  }
}

TEST_CASE("An arc that is too small for its ends is made large enough") {
  const auto points = outline("M0,0 a0.1,0.1 0 0,1 2,0 z", 32);
  for (const auto& p : points) CHECK((p - Vec2(1, 0)).norm() == Approx(1.0));
}

TEST_CASE("Relative and absolute commands draw the same") {
  CHECK(same(outline("M1,1 h2 v3 l-1,1 z"), outline("M1,1 H3 V4 L2,5 Z")));
  CHECK(same(outline("M1,1 c1,0 2,1 2,2 s-1,2 -2,2 z"), outline("M1,1 C2,1 3,2 3,3 S2,5 1,5 Z")));
  CHECK(same(outline("m1,1 q1,0 1,1 t-1,2z"), outline("M1 1Q2 1 2 2T1 4")));
  CHECK(same(outline("M0,0 1,0 1,1 z"), outline("m0,0 1,0 0,1 z")));
  CHECK(same(outline("M0-1L1.5.5L-1e0,+2z"), outline("M 0 -1 L 1.5 0.5 L -1 2 Z")));
}

TEST_CASE("What is no closed outline is refused, and the message says where") {
  for (const char* path :
       {"", "z", "L1,1", "M0,0", "M0,0 L1,1 z", "M0,0 h1 v1 z M2,2 h1 v1 z", "M0,0 h1 vv1",
        "M0,0 a1,1 0 2,1 1,1", "M0,0 h1e9 v1 z", "M0,0 hnan v1 z", "h1 v1", "M0,0 h1 v1 z 3"}) {
    const auto points = outline_of_path(path);
    INFO(path);
    REQUIRE_FALSE(points);
    CHECK(points.error().message.find("byte") != std::string::npos);
  }
  CHECK(outline_of_path(std::string(max_path_bytes + 1, ' ')).error().kind == Error::Kind::limit);
}

TEST_CASE("Whatever the bytes, a path is refused or has a bounded number of finite points") {
  Random random(3);
  const std::string letters = "MmLlHhVvCcSsQqTtAaZz0123456789.,-+e \n";
  int read = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string path = random.chance(0.8) ? "M0,0 h1 v1 " : "";
    for (int n = random.integer(0, 60); n > 0; --n)
      path += random.chance(0.95) ? letters[static_cast<std::size_t>(
                                        random.integer(0, static_cast<int>(letters.size()) - 1))]
                                  : static_cast<char>(random.integer(0, 255));
    const auto points = outline_of_path(path, random.integer(-2, 30));
    if (!points) continue;
    ++read;
    CHECK(points->size() >= 3);
    CHECK(points->size() <= max_outline_points);
    for (const auto& p : *points) CHECK(p.allFinite());
  }
  CHECK(read > 10);
}

TEST_CASE("A line cuts an outline into two parts of its area") {
  Random random(5);
  for (int round = 0; round < 500; ++round) {
    std::vector<Vec2> points;
    const int corners = random.integer(3, 12);
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * pi * i / corners;
      points.push_back(Vec2(std::cos(angle), random.uniform(0.9, 1.1) * std::sin(angle)));
    }
    if (corners > 4) points = outline("M0,-1 a1,1 0 0,1 0,2 a1,1 0 0,1 0,-2z");
    const Vec2 normal = rotated({1, 0}, random.uniform(-pi, pi));
    const double offset = random.uniform(-1.2, 1.2);
    const auto below = clipped(points, normal, offset), above = clipped(points, -normal, -offset);
    for (const auto& p : below) CHECK(normal.dot(p) <= offset + 1e-9);
    const auto area_of = [](const std::vector<Vec2>& p) {
      return p.size() < 3 ? 0.0 : signed_area(p);
    };
    CHECK(area_of(below) + area_of(above) == Approx(signed_area(points)).margin(1e-12));
  }
}
