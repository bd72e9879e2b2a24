#include <Eigen/Geometry>

#include "base/random.h"
#include "catch.h"
#include "primitive_checks.h"
#include "roomgen/geometry/polygon.h"

using namespace roomgen;
using namespace roomgen::shape;

namespace {

Curve<Vec3> helix(double radius, double rise, double turns) {
  Curve<Vec3> curve;
  const int count = static_cast<int>(turns * 8);
  for (int k = 0; k <= count; ++k) {
    const double a = 2 * pi * k / 8;
    curve.points.push_back({radius * std::cos(a), radius * std::sin(a), rise * a / (2 * pi)});
  }
  return curve;
}

Curve<Vec3> ring(double radius, int points) {
  Curve<Vec3> curve{{}, {}, true};
  for (int k = 0; k < points; ++k) {
    const double a = 2 * pi * k / points;
    curve.points.push_back({radius * std::cos(a), radius * std::sin(a), 0.5});
  }
  return curve;
}

}  // namespace

TEST_CASE("A straight sweep has its section's area times its length, in every direction") {
  Random random(21);
  for (int i = 0; i < 60; ++i) {
    Vec3 way(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (i == 0) way = {0, 0, 1};
    if (i == 1) way = {0, 0, -1};
    if (i == 2) way = {-1, 0, 0};
    const Sweep sweep{straight(std::vector<Vec3>{Vec3(1, 2, 3), Vec3(1, 2, 3) + way}, false),
                      rectangle({0.05, 0.03}, 0.0, tolerance)};
    const Mesh bar = sound(mesh(sweep, tolerance));
    CHECK(bar.triangles.size() == 12);
    CHECK(volume(bar) == Approx(0.05 * 0.03 * way.norm()).epsilon(1e-3));
  }
}

TEST_CASE("The section's y is up along a level path and to the back along an upright one") {
  const auto flat = rectangle({0.4, 0.1}, 0.0, tolerance);
  const auto level = straight(std::vector<Vec3>{{0, 0, 0}, {0, 2, 0}}, false);
  CHECK((bounds(*mesh(Sweep{level, flat}, tolerance)).size() - Vec3(0.4, 2, 0.1)).norm() < 1e-6);
  const auto upright = straight(std::vector<Vec3>{{0, 0, 0}, {0, 0, 2}}, false);
  CHECK((bounds(*mesh(Sweep{upright, flat}, tolerance)).size() - Vec3(0.4, 0.1, 2)).norm() < 1e-6);
}

TEST_CASE("A sweep around a circle has the volume that Pappus found") {
  for (double radius : {0.2, 0.5, 1.0}) {
    const Mesh torus = sound(mesh(Sweep{ring(radius, 12), ellipse({0.06, 0.06}, 5e-5)}, 5e-5));
    CHECK(volume(torus) == Approx(2 * pi * radius * pi * 0.0009).epsilon(3e-3));
    const Mesh band = sound(mesh(Sweep{ring(radius, 12), rectangle({0.02, 0.3}, 0.0, 1e-5)}, 1e-5));
    CHECK(volume(band) == Approx(2 * pi * radius * 0.006).epsilon(3e-3));
    CHECK(bounds(band).size().z() == Approx(0.3).epsilon(1e-4));
  }
}

TEST_CASE("Corners are mitred: a frame has the area of its outline less its opening") {
  const auto path = straight(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 0, 2}, {0, 0, 2}}, true);
  const Mesh frame = sound(mesh(Sweep{path, rectangle({0.1, 0.1}, 0.0, tolerance)}, tolerance));
  CHECK(volume(frame) == Approx((1.1 * 2.1 - 0.9 * 1.9) * 0.1).epsilon(1e-4));
  CHECK((bounds(frame).size() - Vec3(1.1, 0.1, 2.1)).norm() < 1e-5);
}

TEST_CASE("Sharp corners of open paths keep the section's thickness") {
  for (double turn : {0.3, 1.0, pi / 2, 2.0, 2.6}) {
    const auto path = straight(
        std::vector<Vec3>{{-1, 0, 0}, {0, 0, 0}, {std::cos(turn), std::sin(turn), 0}}, false);
    const Mesh bent = sound(mesh(Sweep{path, rectangle({0.04, 0.04}, 0.0, tolerance)}, tolerance));
    // What the mitre takes inside it gives outside.
    CHECK(volume(bent) == Approx(2 * 0.0016).epsilon(1e-3));
  }
}

TEST_CASE("Helices and wild smooth paths are sound, tapered and twisted") {
  Random random(22);
  for (int i = 0; i < 60; ++i) {
    Sweep sweep;
    sweep.path = helix(random.uniform(0.1, 0.5), random.uniform(0.1, 0.3), random.uniform(1, 4));
    sweep.section = i % 2 ? ellipse({0.03, 0.03}, tolerance)
                          : rectangle({0.03, 0.02}, i % 4 ? 0.0 : 0.004, tolerance);
    if (i % 3 == 0) sweep.twist = random.uniform(-10, 10);
    if (i % 5 == 0) sweep.taper = random.uniform(0, 1.5);
    if (i % 10 == 0) sweep.taper = 0.0;
    sound(mesh(sweep, tolerance));
  }
}

TEST_CASE("Closed paths in space close without a step") {
  Random random(23);
  for (int i = 0; i < 30; ++i) {
    Curve<Vec3> path{{}, {}, true};
    for (int k = 0; k < 9; ++k) {
      const double a = 2 * pi * k / 9;
      path.points.push_back({std::cos(a), std::sin(a), random.uniform(-0.3, 0.3)});
    }
    Sweep sweep{path, rectangle({0.05, 0.02}, 0.0, tolerance)};
    if (i % 2) sweep.twist = 2 * pi;
    const Mesh loop = sound(mesh(sweep, tolerance));
    // No band of the skin turns by more than a little: its normals stay near their faces.
    for (const auto& t : loop.triangles) {
      const auto normal = (loop.positions[t[1]] - loop.positions[t[0]])
                              .cross(loop.positions[t[2]] - loop.positions[t[0]])
                              .normalized();
      for (auto v : t) CHECK(normal.dot(loop.normals[v]) > 0.7f);
    }
  }
}

TEST_CASE("A taper to a point is a pyramid, and a twist keeps the volume") {
  const auto path = straight(std::vector<Vec3>{{0, 0, 0}, {0, 0, 0.9}}, false);
  Sweep sweep{path, rectangle({0.2, 0.2}, 0.0, tolerance), 0.0, 0.0};
  CHECK(volume(sound(mesh(sweep, tolerance))) == Approx(0.04 * 0.9 / 3).epsilon(1e-4));
  sweep.taper = 1.0;
  sweep.twist = 3.0;
  CHECK(volume(sound(mesh(sweep, 1e-5))) == Approx(0.04 * 0.9).epsilon(0.01));
}

TEST_CASE("Paths that cannot be swept are refused") {
  const auto square = rectangle({0.02, 0.02}, 0.0, tolerance);
  const auto path = straight(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}, false);
  CHECK(mesh(Sweep{path, square}, tolerance));
  CHECK_FALSE(
      mesh(Sweep{straight(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, false), square},
           tolerance));
  CHECK_FALSE(mesh(Sweep{straight(std::vector<Vec3>{{0, 0, 0}}, false), square}, tolerance));
  CHECK_FALSE(mesh(Sweep{path, square, -1.0}, tolerance));
  CHECK_FALSE(mesh(Sweep{path, square, 1.0, 1e9}, tolerance));
  CHECK_FALSE(mesh(Sweep{ring(0.4, 8), square, 0.5}, tolerance));
  CHECK_FALSE(mesh(Sweep{ring(0.4, 8), square, 1.0, 1.0}, tolerance));
  CHECK_FALSE(mesh(Sweep{path, straight(std::vector<Vec2>{{0, 0}, {1, 1}}, true)}, tolerance));
}
