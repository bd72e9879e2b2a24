#include <Eigen/Geometry>

#include "base/random.h"
#include "catch.h"
#include "primitive_checks.h"

using namespace roomgen;
using namespace roomgen::shape;

namespace {

Mesh tube() {
  const auto profile = straight(std::vector<Vec2>{{0.3, 0}, {0.4, 0}, {0.4, 1}, {0.3, 1}}, true);
  return *mesh(Lathe{profile}, tolerance);
}

Mesh star() {
  std::vector<Vec2> outline;
  for (int k = 0; k < 14; ++k) {
    const double a = 2 * pi * k / 14;
    outline.push_back((k % 2 ? 0.2 : 0.6) * Vec2(std::cos(a), std::sin(a)));
  }
  return *mesh(Extrusion{straight(outline, true), {ellipse({0.2, 0.2}, tolerance)}, 0.5, 0.02},
               tolerance);
}

std::vector<Mesh> bodies() {
  return {*mesh(Box{{1, 0.6, 0.8}, 0.05}, tolerance),
          *mesh(Ellipsoid{{0.9, 0.7, 0.8}}, tolerance),
          tube(),
          star(),
          *mesh(Frustum{0.4, 0.2, 0.9, 0.01}, tolerance),
          *mesh(Cushion{{0.8, 0.8, 0.3}, 0.3}, tolerance)};
}

}  // namespace

TEST_CASE("Both halves of a cut are sound and add up to the whole") {
  Random random(31);
  for (const auto& body : bodies())
    for (int i = 0; i < 40; ++i) {
      const Vec3 away(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      const Vec3 point = bounds(body).center() + 0.25 * bounds(body).size().cwiseProduct(away);
      Vec3 normal(random.normal(0, 1), random.normal(0, 1), random.normal(0, 1));
      if (i < 3) normal = Vec3::Unit(i);
      const Mesh below = sound(cut(body, point, normal)), above = sound(cut(body, point, -normal));
      CHECK(volume(below) + volume(above) == Approx(volume(body)).epsilon(1e-4));
      for (const auto& p : below.positions)
        CHECK(normal.normalized().dot(p.cast<double>() - point) < 2e-5);
    }
}

TEST_CASE("A tube cut across has a ring for a cap") {
  const Mesh half = sound(cut(tube(), {0, 0, 0.25}, {0, 0, 1}));
  CHECK(volume(half) == Approx(volume(tube()) / 4).epsilon(1e-4));
  for (const auto& t : half.triangles) {
    Vec3 middle = Vec3::Zero();
    for (auto v : t) middle += half.positions[v].cast<double>() / 3;
    CHECK(middle.head<2>().norm() > 0.28);
  }
}

TEST_CASE("A cut through faces that lie in the plane leaves them out or keeps them") {
  const Mesh box = *mesh(Box{Vec3::Ones(), 0.0}, tolerance);
  CHECK(volume(sound(cut(box, {0, 0, 1}, {0, 0, 1}))) == Approx(1));
  CHECK(cut(box, {0, 0, 1}, {0, 0, -1})->triangles.empty());
  CHECK(cut(box, {0, 0, 5}, {0, 0, -1})->triangles.empty());
  CHECK(volume(sound(cut(box, {0, 0, 5}, {0, 0, 1}))) == Approx(1));
}

TEST_CASE("A body can be cut again and again") {
  Mesh body = *mesh(Ellipsoid{Vec3::Ones()}, tolerance);
  Random random(32);
  for (int i = 0; i < 12; ++i) {
    const Vec3 normal =
        Vec3(random.normal(0, 1), random.normal(0, 1), random.normal(0, 1)).normalized();
    const double before = volume(body);
    body = sound(cut(body, Vec3(0, 0, 0.5) + 0.3 * normal, normal));
    CHECK(volume(body) < before + 1e-9);
  }
  CHECK(volume(body) > 4.0 / 3 * pi * 0.027 * 0.9);
}

TEST_CASE("Planes without direction and open meshes are refused") {
  Mesh box = *mesh(Box{}, tolerance);
  CHECK_FALSE(cut(box, Vec3::Zero(), Vec3::Zero()));
  CHECK_FALSE(cut(box, Vec3(0, 0, 1.0 / 0.0), Vec3::UnitZ()));
  box.triangles.pop_back();
  CHECK_FALSE(cut(box, Vec3::Zero(), Vec3::UnitZ()));
}

TEST_CASE("Closedness sees a missing, a turned and a doubled triangle") {
  const Mesh box = *mesh(Box{Vec3::Ones(), 0.1}, tolerance);
  REQUIRE(is_closed(box));
  Mesh missing = box, turned = box, doubled = box;
  missing.triangles.pop_back();
  std::swap(turned.triangles[5][0], turned.triangles[5][1]);
  doubled.triangles.push_back(doubled.triangles[0]);
  CHECK_FALSE(is_closed(missing));
  CHECK_FALSE(is_closed(turned));
  CHECK_FALSE(is_closed(doubled));
}
