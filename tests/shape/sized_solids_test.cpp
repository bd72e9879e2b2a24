// Solids that are given by their sizes: they stand on z = 0, centred, and fill their size.

#include <Eigen/Geometry>
#include <limits>

#include "base/random.h"
#include "catch.h"
#include "primitive_checks.h"

using namespace roomgen;
using namespace roomgen::shape;

namespace {

Vec3 random_size(Random& random) {
  const double scale = random.uniform(0.02, 1.5);
  return scale * Vec3(random.uniform(0.05, 1), random.uniform(0.05, 1), random.uniform(0.05, 1));
}

void check_fills(const Mesh& mesh, const Vec3& size) {
  const auto box = bounds(mesh);
  CHECK((box.size() - size).norm() < 1e-6);
  CHECK(box.center().head<2>().norm() < 1e-6);
  CHECK(std::abs(box.low.z()) < 1e-6);
}

double ellipsoid_volume(const Vec3& size) {
  return pi / 6 * size.prod();
}

double frustum_volume(double a, double b, double height) {
  return pi / 3 * height * (a * a + a * b + b * b);
}

// Of |x|^p + |y|^p + |z|^p = 1 in the box of the size (Barr 1981).
double superellipsoid_volume(const Vec3& size, double p) {
  return size.prod() * std::pow(std::tgamma(1 + 1 / p), 3) / std::tgamma(1 + 3 / p);
}

}  // namespace

TEST_CASE("A sharp box is twelve triangles of its volume") {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const Vec3 size = random_size(random);
    const Mesh box = sound(mesh(Box{size, 0.0}, tolerance));
    CHECK(box.triangles.size() == 12);
    CHECK(volume(box) == Approx(size.prod()).epsilon(1e-4));
    check_fills(box, size);
  }
}

TEST_CASE("A rounded box has the volume of a box swept by a ball") {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Vec3 size = random_size(random);
    const double r = random.uniform(0.01, 0.5) * size.minCoeff();
    const Mesh box = sound(mesh(Box{size, r}, 1e-4 * r + 1e-6));
    const Vec3 in = (size.array() - 2 * r).matrix();
    const double expected = in.prod() +
                            2 * r * (in.x() * in.y() + in.y() * in.z() + in.z() * in.x()) +
                            pi * r * r * in.sum() + 4.0 / 3 * pi * r * r * r;
    CHECK(volume(box) == Approx(expected).epsilon(4e-3));
    check_fills(box, size);
  }
}

TEST_CASE("A bevel larger than the box makes the box as round as it can be") {
  const Mesh ball = sound(mesh(Box{Vec3::Constant(0.4), 3.0}, 1e-4));
  CHECK(volume(ball) == Approx(ellipsoid_volume(Vec3::Constant(0.4))).epsilon(0.01));
}

TEST_CASE("Flat faces of a rounded box are shaded flat") {
  const Mesh box = sound(mesh(Box{{1.0, 0.6, 0.4}, 0.02}, tolerance));
  for (std::size_t v = 0; v < box.positions.size(); ++v) {
    const auto& p = box.positions[v];
    if (std::abs(p.z() - 0.4f) < 1e-6f) CHECK(box.normals[v].z() > 0.9999f);
  }
}

TEST_CASE("Frustums of all kinds have their volume and stand on the floor") {
  Random random(3);
  for (int i = 0; i < 150; ++i) {
    double a = random.uniform(0.01, 0.5), b = random.uniform(0.01, 0.5);
    if (i % 5 == 0) b = 0.0;
    if (i % 7 == 0 && b > 0) a = 0.0;
    const double height = random.uniform(0.02, 1.5);
    const Mesh cone = sound(mesh(Frustum{a, b, height, 0.0}, 1e-5));
    CHECK(volume(cone) == Approx(frustum_volume(a, b, height)).epsilon(5e-3));
    check_fills(cone, {2 * std::max(a, b), 2 * std::max(a, b), height});
  }
}

TEST_CASE("A frustum's rims are rounded, never by more than there is room") {
  Random random(4);
  for (int i = 0; i < 150; ++i) {
    Frustum solid{random.uniform(0.01, 0.4), random.uniform(0.01, 0.4), random.uniform(0.02, 1.0),
                  0.0};
    if (i % 6 == 0) solid.top_radius = 0.0;
    const double sharp = volume(sound(mesh(solid, 1e-4)));
    solid.bevel = random.uniform(0.001, 0.6);
    const Mesh round = sound(mesh(solid, 1e-4));
    CHECK(volume(round) < sharp);
    CHECK(bounds(round).size().z() <= solid.height + 1e-6);
    CHECK(bounds(round).low.z() == Approx(0).margin(1e-6));
  }
  // A cylinder rounded by its radius is a ball when it is as high as wide.
  const Mesh ball = sound(mesh(Frustum{0.2, 0.2, 0.4, 0.2}, 1e-5));
  CHECK(volume(ball) == Approx(ellipsoid_volume(Vec3::Constant(0.4))).epsilon(5e-3));
}

TEST_CASE("Cylinders have as many sides as the tolerance asks for") {
  const auto sides = [](double radius) {
    // Two triangles a side and two caps of two less than the sides.
    return (sound(mesh(Frustum{radius, radius, 0.5, 0.0}, tolerance)).triangles.size() + 4) / 4;
  };
  CHECK(sides(0.002) == 8);
  CHECK(sides(0.02) >= 12);
  CHECK(sides(0.02) <= 20);
  CHECK(sides(0.5) >= 48);
  CHECK(sides(0.5) <= 56);
}

TEST_CASE("No chord is further from a cylinder than the tolerance") {
  for (double radius : {0.003, 0.02, 0.1, 0.77, 3.0})
    for (double chord : {1e-4, 1e-3, 1e-2}) {
      const Mesh cylinder = sound(mesh(Frustum{radius, radius, 0.5, 0.0}, chord));
      for (const auto& t : cylinder.triangles)
        for (int k = 0; std::abs(cylinder.normals[t[0]].z()) < 0.5f && k < 3; ++k) {
          const Eigen::Vector3f middle =
              0.5f * (cylinder.positions[t[k]] + cylinder.positions[t[(k + 1) % 3]]);
          const Eigen::Vector2f a = cylinder.positions[t[k]].head<2>(),
                                b = cylinder.positions[t[(k + 1) % 3]].head<2>();
          if (a.norm() > 0.9 * radius && b.norm() > 0.9 * radius && (a - b).norm() < radius)
            CHECK(middle.head<2>().norm() > radius - chord - 1e-6);
        }
    }
}

TEST_CASE("Ellipsoids fill their size and come nearer to their volume as the tolerance falls") {
  Random random(5);
  for (int i = 0; i < 60; ++i) {
    const Vec3 size = random_size(random);
    const double expected = ellipsoid_volume(size);
    const double scale = size.maxCoeff();
    const Mesh coarse = sound(mesh(Ellipsoid{size}, 0.02 * scale)),
               fine = sound(mesh(Ellipsoid{size}, 0.0005 * scale));
    check_fills(coarse, size);
    check_fills(fine, size);
    CHECK(volume(fine) == Approx(expected).epsilon(0.02));
    CHECK(volume(coarse) < volume(fine));
    CHECK(volume(fine) < expected);
    CHECK(coarse.triangles.size() < fine.triangles.size());
  }
}

TEST_CASE("The normals of a ball point away from its middle") {
  const Mesh ball = sound(mesh(Ellipsoid{Vec3::Constant(0.6)}, tolerance));
  for (std::size_t v = 0; v < ball.positions.size(); ++v) {
    const Vec3 out = (ball.positions[v].cast<double>() - Vec3(0, 0, 0.3)).normalized();
    CHECK(ball.normals[v].cast<double>().dot(out) > 0.99999);
  }
}

TEST_CASE("Cushions fill their size between ellipsoid and box") {
  Random random(6);
  for (int i = 0; i < 80; ++i) {
    const Vec3 size = random_size(random);
    const double softness = random.uniform(0.1, 1.0);
    const Mesh cushion = sound(mesh(Cushion{size, softness}, 0.0005 * size.maxCoeff()));
    check_fills(cushion, size);
    CHECK(volume(cushion) == Approx(superellipsoid_volume(size, 2 / softness)).epsilon(0.02));
  }
}

TEST_CASE("Prisms and pyramids have flat sides, the first to the front") {
  Random random(7);
  for (int i = 0; i < 80; ++i) {
    const int sides = random.integer(3, 12);
    double a = random.uniform(0.02, 0.5), b = random.uniform(0.02, 0.5);
    if (i % 4 == 0) b = 0.0;
    const double height = random.uniform(0.02, 1.0);
    const Mesh prism = sound(mesh(Prism{sides, a, b, height}, tolerance));
    const double share = sides / (2 * pi) * std::sin(2 * pi / sides);
    CHECK(volume(prism) == Approx(share * frustum_volume(a, b, height)).epsilon(1e-3));
    CHECK(bounds(prism).low.y() == Approx(-std::max(a, b) * std::cos(pi / sides)).epsilon(1e-5));
    for (const auto& t : prism.triangles) {
      const auto normal = (prism.positions[t[1]] - prism.positions[t[0]])
                              .cross(prism.positions[t[2]] - prism.positions[t[0]])
                              .normalized();
      for (auto v : t) CHECK(prism.normals[v].dot(normal) > 0.999f);
    }
  }
}

TEST_CASE("A plane is a thin box") {
  const Mesh slab = sound(mesh(Plane{{2.0, 1.4}, 0.008}, tolerance));
  CHECK(volume(slab) == Approx(2.0 * 1.4 * 0.008).epsilon(1e-4));
  check_fills(slab, {2.0, 1.4, 0.008});
}

TEST_CASE("Textures have one scale on boxes and cylinders: an edge is as long in uv as in space") {
  for (const auto& made :
       {mesh(Box{{1.0, 0.5, 0.3}, 0.0}, tolerance), mesh(Plane{{1.0, 2.0}, 0.01}, tolerance),
        mesh(Frustum{0.3, 0.3, 0.5, 0.0}, tolerance)}) {
    const Mesh m = sound(made);
    for (const auto& t : m.triangles)
      for (int k = 0; k < 3; ++k) {
        const auto a = t[k], b = t[(k + 1) % 3];
        CHECK((m.uvs[a] - m.uvs[b]).norm() ==
              Approx((m.positions[a] - m.positions[b]).norm()).epsilon(1e-3));
      }
  }
}

TEST_CASE("The grain runs along the longer side") {
  const Mesh leg = sound(mesh(Box{{0.04, 0.04, 0.7}, 0.0}, tolerance));
  for (const auto& t : leg.triangles)
    for (int k = 0; k < 3; ++k) {
      const auto a = t[k], b = t[(k + 1) % 3];
      const float rise = std::abs(leg.positions[a].z() - leg.positions[b].z());
      CHECK(std::abs(leg.uvs[a].x() - leg.uvs[b].x()) >= rise - 1e-5f);
    }
}

TEST_CASE("Sizes that make no solid are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = 1.0 / 0.0;
  for (double bad : {0.0, -1.0, nan, inf, 1e-9}) {
    CHECK_FALSE(mesh(Box{{1, bad, 1}, 0}, tolerance));
    CHECK_FALSE(mesh(Ellipsoid{{bad, 1, 1}}, tolerance));
    CHECK_FALSE(mesh(Cushion{{1, 1, bad}, 0.4}, tolerance));
    CHECK_FALSE(mesh(Cushion{{1, 1, 1}, bad}, tolerance));
    CHECK_FALSE(mesh(Frustum{0.1, 0.1, bad, 0}, tolerance));
    CHECK_FALSE(mesh(Prism{6, 0.1, 0.1, bad}, tolerance));
    CHECK_FALSE(mesh(Plane{{1, 1}, bad}, tolerance));
    CHECK_FALSE(mesh(Box{{1, 1, 1}, 0}, bad));
  }
  for (double bad : {-1.0, nan, inf}) {
    CHECK_FALSE(mesh(Box{{1, 1, 1}, bad}, tolerance));
    CHECK_FALSE(mesh(Frustum{bad, 0.1, 1, 0}, tolerance));
    CHECK_FALSE(mesh(Frustum{0.1, bad, 1, 0}, tolerance));
    CHECK_FALSE(mesh(Prism{6, bad, 0.1, 1}, tolerance));
  }
  CHECK_FALSE(mesh(Frustum{0, 0, 1, 0}, tolerance));
  CHECK_FALSE(mesh(Prism{2, 0.1, 0.1, 1}, tolerance));
  CHECK_FALSE(mesh(Cushion{{1, 1, 1}, 1.5}, tolerance));
  CHECK(mesh(Box{{1, 0, 1}, 0}, tolerance).error().kind == Error::Kind::invalid_input);
}
