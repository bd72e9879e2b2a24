// Solids of drawn profiles, outlines and levels, and those of a formula.

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/random.h"
#include "catch.h"
#include "primitive_checks.h"
#include "roomgen/base/json.h"
#include "roomgen/geometry/polygon.h"

using namespace roomgen;
using namespace roomgen::shape;

namespace {

using Points = std::vector<Vec2>;

Curve<Vec2> star(Random& random, int points, double inner, double outer) {
  Points result;
  for (int k = 0; k < points; ++k) {
    const double angle = 2 * pi * (k + random.uniform(-0.3, 0.3)) / points;
    result.push_back(random.uniform(inner, outer) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return straight(result, true);
}

Curve<Vec2> moved(Curve<Vec2> curve, const Vec2& by, double scale = 1.0) {
  for (auto& p : curve.points) p = scale * p + by;
  return curve;
}

Curve<Vec2> reversed(Curve<Vec2> curve) {
  std::reverse(curve.points.begin(), curve.points.end());
  for (auto& c : curve.corners) c = curve.points.size() - 1 - c;
  return curve;
}

double area_of(const Curve<Vec2>& curve, double at = tolerance) {
  return std::abs(signed_area(polyline(curve, at)));
}

}  // namespace

TEST_CASE("Four smooth points on a circle are a circle") {
  const Curve<Vec2> curve{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, {}, true};
  const auto points = polyline(curve, 1e-4);
  CHECK(points.size() > 100);
  for (const auto& p : points) CHECK(p.norm() == Approx(1).epsilon(1e-3));
}

TEST_CASE("A straight curve keeps its points and adds none") {
  const Points points{{0, 0}, {1, 0}, {1, 1}, {0.2, 1.5}};
  CHECK(polyline(straight(points, false), 1e-5) == points);
  CHECK(polyline(straight(points, true), 1e-5) == points);
}

TEST_CASE("A finer polyline lies within the tolerance of a coarser one") {
  Random random(11);
  for (int i = 0; i < 50; ++i) {
    Curve<Vec3> curve;
    for (int k = 0; k < 6; ++k)
      curve.points.push_back({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, 1)});
    curve.closed = i % 2;
    const auto coarse = polyline(curve, 0.01), fine = polyline(curve, 1e-5);
    CHECK(coarse.size() < fine.size());
    const std::size_t pieces = coarse.size() - (curve.closed ? 0 : 1);
    for (const auto& p : fine) {
      double nearest = 1e9;
      for (std::size_t k = 0; k < pieces; ++k) {
        const Vec3 a = coarse[k], d = coarse[(k + 1) % coarse.size()] - a;
        const double t = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (a + t * d - p).norm());
      }
      CHECK(nearest < 0.0105);
    }
  }
}

TEST_CASE("Named outlines fill their size") {
  CHECK(area_of(ellipse({2, 1}, 1e-4), 1e-4) == Approx(pi / 2).epsilon(1e-3));
  CHECK(area_of(rectangle({2, 1}, 0, tolerance)) == Approx(2));
  CHECK(area_of(rectangle({2, 1}, 0.1, 1e-5), 1e-5) == Approx(2 - (4 - pi) * 0.01).epsilon(1e-3));
  CHECK(area_of(rounded({2, 1}, 0, tolerance)) == Approx(2));
  CHECK(area_of(rounded({2, 1}, 1, 1e-4), 1e-4) == Approx(pi / 2).epsilon(1e-3));
  CHECK(area_of(rounded({2, 1}, 0.5, 1e-5), 1e-5) == Approx(2 - (4 - pi) * 0.125).epsilon(1e-2));
}

TEST_CASE("A turned profile has the volume that Pappus found, whichever way it is drawn") {
  Random random(12);
  for (int i = 0; i < 60; ++i) {
    const double middle = random.uniform(0.3, 0.6);
    const auto profile = moved(star(random, random.integer(3, 9), 0.05, 0.25), {middle, 0.3});
    double moment = 0.0;  // of area about the axis
    const auto& p = profile.points;
    for (std::size_t k = 0; k < p.size(); ++k) {
      const Vec2 &a = p[k], &b = p[(k + 1) % p.size()];
      moment += cross(a, b) * (a.x() + b.x()) / 6;
    }
    const double angle = i % 3 ? 2 * pi : random.uniform(0.3, 6.0);
    for (const auto& drawn : {profile, reversed(profile)}) {
      const Mesh ring = sound(mesh(Lathe{drawn, angle}, 1e-4));
      CHECK(volume(ring) == Approx(angle * moment).epsilon(5e-3));
    }
  }
}

TEST_CASE("An open profile is closed along the axis") {
  const std::vector<Points> profiles = {{{0, 0}, {0.2, 0}, {0.2, 0.5}, {0, 0.5}},
                                        {{0.2, 0}, {0.2, 0.5}},
                                        {{0.2, 0}, {0.2, 0.5}, {0, 0.5}},
                                        {{0.2, 0.5}, {0.2, 0.25}, {0.2, 0}}};
  for (const auto& profile : profiles)
    for (double angle : {2 * pi, 1.0, pi}) {
      const Mesh body = sound(mesh(Lathe{straight(profile, false), angle}, 1e-5));
      CHECK(volume(body) == Approx(angle / 2 * 0.04 * 0.5).epsilon(2e-3));
    }
}

TEST_CASE("Profiles that come back to the axis, start at a point or swing over leave no flaw") {
  for (const Points& profile : {Points{{0, 0}, {0.3, 0.2}, {0, 0.4}, {0.3, 0.6}, {0, 0.8}},
                                Points{{0, 0}, {0.2, 0.1}, {0.05, 0.5}, {0.15, 0.9}, {0, 1}},
                                Points{{0.15, 0}, {0.25, 0.2}, {0.08, 0.4}, {0.1, 0.45}}})
    for (bool smooth : {false, true}) {
      Curve<Vec2> curve = straight(profile, false);
      if (smooth) curve.corners = {2};
      for (double angle : {2 * pi, 4.0}) {
        const Mesh body = sound(mesh(Lathe{curve, angle}, tolerance));
        CHECK(bounds(body).low.z() == Approx(profile.front().y()).margin(0.02));
      }
    }
}

TEST_CASE("A part of a turn opens to the front") {
  const Mesh part = sound(mesh(
      Lathe{straight(Points{{0.3, 0}, {0.4, 0}, {0.4, 0.2}, {0.3, 0.2}}, true), pi}, tolerance));
  CHECK(bounds(part).low.y() == Approx(0).margin(1e-6));
  CHECK(bounds(part).high.y() == Approx(0.4));
}

TEST_CASE("Extrusions have area times height, holes taken off") {
  Random random(13);
  for (int i = 0; i < 80; ++i) {
    Extrusion solid;
    solid.outline = star(random, random.integer(5, 24), 0.5, 1.0);
    if (i % 2) solid.outline = reversed(solid.outline);
    solid.height = random.uniform(0.01, 0.5);
    double area = area_of(solid.outline);
    const int holes = i % 4;
    for (int k = 0; k < holes; ++k) {
      const Vec2 at = 0.22 * Vec2(std::cos(2.1 * k), std::sin(2.1 * k));
      solid.holes.push_back(moved(star(random, random.integer(3, 12), 0.3, 1.0), at, 0.12));
      if (k % 2) solid.holes.back() = reversed(solid.holes.back());
      area -= area_of(solid.holes.back());
    }
    CHECK(volume(sound(mesh(solid, tolerance))) == Approx(area * solid.height).epsilon(1e-4));
  }
}

TEST_CASE("A bevelled extrusion loses a little at its edges and keeps its bounds") {
  Random random(14);
  for (int i = 0; i < 60; ++i) {
    Extrusion solid;
    solid.outline = i % 2 ? star(random, random.integer(5, 12), 0.6, 1.0)
                          : rounded({random.uniform(0.3, 2), random.uniform(0.3, 2)},
                                    random.uniform(0, 1), tolerance);
    solid.holes = {ellipse({0.1, 0.2}, tolerance)};
    solid.height = random.uniform(0.02, 0.3);
    const Mesh sharp = sound(mesh(solid, tolerance));
    solid.bevel = random.uniform(0.001, 0.3);
    const Mesh soft = sound(mesh(solid, tolerance));
    CHECK(volume(soft) < volume(sharp));
    CHECK((bounds(soft).size() - bounds(sharp).size()).norm() < 1e-6);
  }
}

TEST_CASE("Points in the middle of straight sides do no harm to caps") {
  Points points;
  for (int k = 0; k < 10; ++k) points.push_back({0.1 * k, 0});
  for (int k = 0; k < 10; ++k) points.push_back({1, 0.1 * k});
  for (int k = 0; k < 10; ++k) points.push_back({1 - 0.1 * k, 1});
  for (int k = 0; k < 10; ++k) points.push_back({0, 1 - 0.1 * k});
  CHECK(volume(sound(mesh(Extrusion{straight(points, true), {}, 0.3, 0}, tolerance))) ==
        Approx(0.3));
}

TEST_CASE("A straight loft between like rectangles is a frustum of a pyramid") {
  Random random(15);
  for (int i = 0; i < 50; ++i) {
    const Vec2 a(random.uniform(0.1, 1), random.uniform(0.1, 1)),
        b(random.uniform(0.1, 1), random.uniform(0.1, 1));
    const double h = random.uniform(0.05, 1);
    Loft loft{{{0.0, rectangle(a, 0, tolerance)}, {h, rectangle(b, 0, tolerance)}}, true};
    const Mesh body = sound(mesh(loft, tolerance));
    CHECK(body.triangles.size() == 12);
    // The prismatoid formula.
    const Vec2 middle = 0.5 * (a + b);
    CHECK(volume(body) == Approx(h / 6 * (a.prod() + 4 * middle.prod() + b.prod())).epsilon(2e-3));
  }
}

TEST_CASE("Lofts between any outlines are sound") {
  Random random(16);
  for (int i = 0; i < 80; ++i) {
    Loft loft;
    const int levels = random.integer(2, 5);
    for (int k = 0; k < levels; ++k) {
      Curve<Vec2> outline = rounded({random.uniform(0.1, 1), random.uniform(0.1, 1)},
                                    random.chance(0.3) ? 0.0 : random.uniform(0, 1.2), tolerance);
      if (random.chance(0.2)) outline = star(random, 5, 0.4, 0.5);
      loft.levels.push_back({k * random.uniform(0.2, 0.3) + 0.3 * k, outline});
    }
    loft.straight = i % 2;
    const Mesh body = sound(mesh(loft, tolerance));
    CHECK(bounds(body).low.z() == Approx(0).margin(1e-6));
    CHECK(bounds(body).high.z() == Approx(loft.levels.back().z));
  }
}

TEST_CASE("A smooth loft of equal circles is a cylinder") {
  const auto round = ellipse({0.5, 0.5}, 1e-5);
  const Mesh body = sound(mesh(Loft{{{0, round}, {0.2, round}, {0.6, round}}, false}, 1e-5));
  CHECK(volume(body) == Approx(pi * 0.0625 * 0.6).epsilon(1e-3));
}

TEST_CASE("A height field is as high as its formula, within its bounds") {
  HeightField field{{1.2, 0.8}, [](double u, double v) { return 0.2 + 0.1 * u + 0.05 * v; }, 24};
  const Mesh slope = sound(mesh(field, tolerance));
  CHECK(volume(slope) == Approx(1.2 * 0.8 * 0.2).epsilon(1e-4));
  CHECK(bounds(slope).high.z() == Approx(0.35));
  CHECK(bounds(slope).size().head<2>().isApprox(Vec2(1.2, 0.8), 1e-6));

  field.height = [](double u, double v) { return 9 * u * v - 1; };
  field.most = 0.7;
  const Mesh rough = sound(mesh(field, tolerance));
  CHECK(bounds(rough).high.z() == Approx(0.7));
  CHECK(bounds(rough).low.z() == Approx(0).margin(1e-9));
}

TEST_CASE("A height field of any divisions is sound") {
  for (int divisions : {2, 3, 17, 64, 128})
    for (Vec2 size : {Vec2(1, 1), Vec2(2, 0.05), Vec2(0.3, 1)}) {
      const auto wave = [](double u, double v) {
        return 0.05 + 0.03 * std::sin(7 * u) * std::cos(5 * v);
      };
      sound(mesh(HeightField{size, wave, divisions}, tolerance));
    }
}

TEST_CASE("A flat leaf has its length and width") {
  Random random(17);
  for (int i = 0; i < 60; ++i) {
    Leaf leaf;
    leaf.length = random.uniform(0.03, 0.8);
    leaf.width = leaf.length * random.uniform(0.1, 0.9);
    leaf.widest = random.uniform(0.1, 0.9);
    leaf.fold = 0.0;
    const Mesh flat = sound(mesh(leaf, tolerance));
    CHECK(bounds(flat).low.x() == Approx(0).margin(1e-7));
    CHECK((bounds(flat).size() - Vec3(leaf.length, leaf.width, leaf.thickness)).norm() < 1e-5);
    leaf.fold = random.uniform(-0.8, 0.8);
    leaf.bend = random.uniform(-2, 2);
    const Mesh bent = sound(mesh(leaf, tolerance));
    CHECK(bent.triangles.size() < 400);
  }
}

TEST_CASE("A leaf bends up by its angle") {
  Leaf leaf{0.3, 0.05, 0.001, pi / 2, 0.0, 0.4};
  const auto box = bounds(sound(mesh(leaf, 1e-4)));
  const double radius = 0.3 / (pi / 2);
  CHECK(box.high.z() == Approx(radius).epsilon(0.01));
  CHECK(box.high.x() == Approx(radius).epsilon(0.01));
}

TEST_CASE("Drawings that make no solid are refused") {
  const Points square{{0.1, 0}, {1, 0}, {1, 1}, {0.1, 1}}, bow{{0.1, 0}, {1, 1}, {1, 0}, {0.1, 1}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(mesh(Extrusion{straight(square, true), {}, 0.1, 0}, tolerance));
  CHECK_FALSE(mesh(Extrusion{straight(bow, true), {}, 0.1, 0}, tolerance));
  CHECK_FALSE(mesh(Extrusion{straight(square, true), {}, -0.1, 0}, tolerance));
  CHECK_FALSE(
      mesh(Extrusion{straight(Points{{0, 0}, {1, 0}, {2, 0}}, true), {}, 0.1, 0}, tolerance));
  CHECK_FALSE(
      mesh(Extrusion{straight(Points{{0, 0}, {1, nan}, {2, 0}}, true), {}, 0.1, 0}, tolerance));
  CHECK_FALSE(mesh(Extrusion{Curve<Vec2>{square, {7}, true}, {}, 0.1, 0}, tolerance));
  const auto small = moved(straight(square, true), {0.4, 0.4}, 0.1);
  CHECK(mesh(Extrusion{straight(square, true), {small}, 0.1, 0}, tolerance));
  CHECK_FALSE(mesh(Extrusion{straight(square, true), {moved(small, {5, 5})}, 0.1, 0}, tolerance));
  CHECK_FALSE(
      mesh(Extrusion{straight(square, true), {moved(small, {0.55, 0})}, 0.1, 0}, tolerance));
  CHECK_FALSE(mesh(Extrusion{straight(square, true), {small, small}, 0.1, 0}, tolerance));

  CHECK_FALSE(mesh(Lathe{straight(Points{{-0.1, 0}, {0.3, 1}}, false)}, tolerance));
  CHECK_FALSE(mesh(Lathe{straight(Points{{0, 0}, {0, 1}}, false)}, tolerance));
  CHECK_FALSE(mesh(Lathe{straight(bow, true)}, tolerance));
  CHECK_FALSE(mesh(Lathe{straight(square, true), 0.0}, tolerance));
  CHECK_FALSE(mesh(Lathe{straight(square, true), 7.0}, tolerance));
  CHECK_FALSE(mesh(Lathe{straight(Points{}, false)}, tolerance));

  CHECK_FALSE(mesh(Loft{{{0, straight(square, true)}}, false}, tolerance));
  CHECK_FALSE(
      mesh(Loft{{{0, straight(square, true)}, {0, straight(square, true)}}, false}, tolerance));
  CHECK_FALSE(mesh(HeightField{}, tolerance));
  CHECK_FALSE(mesh(HeightField{{1, 1}, [=](double, double) { return nan; }}, tolerance));
  CHECK_FALSE(mesh(HeightField{{1, 1}, [](double, double) { return 1.0; }, 1}, tolerance));
  Leaf leaf;
  leaf.widest = 0.0;
  CHECK_FALSE(mesh(leaf, tolerance));
}
