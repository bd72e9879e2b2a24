#include "collision/mesh_distance.h"

#include <Eigen/Geometry>

#include "base/random.h"
#include "catch.h"
#include "roomgen/shape/primitives.h"

using namespace roomgen;

namespace {

MeshSolid box(const Vec3& low, const Vec3& high) {
  return MeshSolid(make_box(low, high));
}

template <typename Solid>
MeshSolid placed(const Solid& solid, const Vec3& at, double about_y = 0.0) {
  auto mesh = shape::mesh(solid, 0.0002);
  REQUIRE(mesh);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(about_y, Vec3::UnitY()).toRotationMatrix();
  for (Eigen::Vector3f& p : mesh->positions) p = (turn * p.cast<double>() + at).cast<float>();
  return MeshSolid(*std::move(mesh));
}

MeshSolid ball(const Vec3& center, double radius) {
  return placed(shape::Ellipsoid{Vec3::Constant(2 * radius)}, center - Vec3(0, 0, radius));
}

}  // namespace

TEST_CASE("Boxes are as far apart as their faces, edges and corners") {
  const auto unit = box({0, 0, 0}, {1, 1, 1});
  CHECK(nearest_points(unit, box({1.25, 0, 0}, {2, 1, 1}))->distance == Approx(0.25));
  CHECK(nearest_points(unit, box({1.3, 1.4, 0}, {2, 2, 1}))->distance == Approx(0.5));
  CHECK(nearest_points(unit, box({1.1, 1.2, 1.2}, {2, 2, 2}))->distance == Approx(0.3));
}

TEST_CASE("The nearest points lie on the surfaces and their distance is the distance") {
  const auto a = ball({0, 0, 0.5}, 0.3), b = ball({1, 0, 0.5}, 0.2);
  const auto nearest = nearest_points(a, b);
  REQUIRE(nearest);
  CHECK(nearest->distance == Approx(0.5).margin(0.001));
  CHECK((nearest->on_a - nearest->on_b).norm() == Approx(nearest->distance).margin(1e-6));
  CHECK((nearest->on_a - Vec3(0.3, 0, 0.5)).norm() < 0.02);
  CHECK((nearest->on_b - Vec3(0.8, 0, 0.5)).norm() < 0.02);
}

TEST_CASE("A leaning cylinder is measured from its rim") {
  // Top centre at (sin 30, 0, cos 30); the rim's highest point is radius * sin 30 above it.
  const auto leg = placed(shape::Frustum{0.02, 0.02, 1.0}, Vec3::Zero(), radians(30));
  const double top = std::cos(radians(30)) + 0.02 * std::sin(radians(30));
  const auto slab = box({-1, -1, top + 0.07}, {1, 1, top + 0.1});
  CHECK(nearest_points(leg, slab)->distance == Approx(0.07).margin(0.0005));
}

TEST_CASE("Things that intersect or lie in each other have the distance 0") {
  const auto big = box({0, 0, 0}, {1, 1, 1});
  CHECK(nearest_points(big, box({0.9, 0.9, 0.9}, {2, 2, 2}))->distance == 0.0);
  const auto small = box({0.4, 0.4, 0.4}, {0.6, 0.6, 0.6});
  CHECK(nearest_points(big, small)->distance == 0.0);
  CHECK(nearest_points(small, big)->distance == 0.0);
  CHECK(contains(big, nearest_points(small, big)->on_a));
  const auto crossing = box({0.4, 0.4, -1}, {0.6, 0.6, 2});
  CHECK(nearest_points(big, crossing)->distance == 0.0);
}

TEST_CASE("What stands in a hollow does not touch its walls") {
  const shape::Lathe cup{shape::straight(
      std::vector<Vec2>{{0, 0}, {0.1, 0}, {0.1, 0.2}, {0.09, 0.2}, {0.09, 0.01}, {0, 0.01}},
      false)};
  const auto inside = box({-0.02, -0.02, 0.05}, {0.02, 0.02, 0.1});
  CHECK(nearest_points(placed(cup, Vec3::Zero()), inside)->distance == Approx(0.04).margin(0.001));
}

TEST_CASE("A limit answers nothing beyond it and the distance within it") {
  const auto a = box({0, 0, 0}, {1, 1, 1}), b = box({1.1, 0, 0}, {2, 1, 1});
  CHECK_FALSE(nearest_points(a, b, 0.09));
  REQUIRE(nearest_points(a, b, 0.11));
  CHECK(nearest_points(a, b, 0.11)->distance == Approx(0.1));
  CHECK(nearest_points(box({0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}), a, 0.002)->distance == 0.0);
}

TEST_CASE("What is within a limit has its nearest points there") {
  Random random(7);
  const auto somewhere = [&] {
    const double x = random.uniform(), y = random.uniform();
    return Vec3(x, y, random.uniform());
  };
  for (int k = 0; k < 60; ++k) {
    const auto round = ball(somewhere(), 0.1);
    const auto leg = placed(shape::Frustum{0.03, 0.05, 0.4}, somewhere(), random.uniform(0, 3));
    for (double limit : {0.002, 0.1, 0.3})
      CHECK(within(round, leg, limit) == nearest_points(leg, round, limit).has_value());
  }
}

TEST_CASE("Overlapping surfaces in one mesh are one solid") {
  Mesh mesh = make_box({0, 0, 0}, {1, 1, 1});
  append(mesh, make_box({0.5, 0, 0}, {1.5, 1, 1}));
  append(mesh, make_box({5, 0, 0}, {6, 1, 1}));
  const MeshSolid both(mesh);
  CHECK(contains(both, {0.75, 0.5, 0.5}));
  CHECK(contains(both, {1.4, 0.5, 0.5}));
  CHECK_FALSE(contains(both, {3, 0.5, 0.5}));
  // The third is in what the first is not in.
  CHECK(nearest_points(both, box({4, -1, -1}, {7, 2, 2}))->distance == 0.0);
}

TEST_CASE("Distances agree with those of sampled points") {
  Random random(7);
  for (int k = 0; k < 20; ++k) {
    const auto a = placed(shape::Prism{5, 0.2, 0.1, 0.4}, Vec3::Zero(), random.uniform(-1, 1));
    const Vec3 at(random.uniform(0.5, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const auto b = placed(shape::Cushion{{0.3, 0.2, 0.1}, 0.4}, at, random.uniform(-1, 1));
    const auto nearest = nearest_points(a, b);
    REQUIRE(nearest);
    double sampled = 1e9;
    for (const auto& p : b.mesh().positions)
      sampled = std::min(sampled, distance(a, p.cast<double>()));
    CHECK(nearest->distance <= sampled + 1e-6);
    CHECK(nearest->distance >= sampled - 0.03);
  }
}

TEST_CASE("The area of a contact") {
  const auto slab = box({-1, -1, 0.5}, {1, 1, 0.55});
  const double near = 0.0005;
  // The foot of a post and a strip of its sides.
  const auto post = box({-0.05, -0.05, 0}, {0.05, 0.05, 0.5});
  CHECK(contact_area(post, slab, near) == Approx(0.01).epsilon(0.1));
  CHECK(contact_area(slab, post, near) == Approx(0.01).epsilon(0.1));
  const auto deep = box({-0.05, -0.05, 0}, {0.05, 0.05, 0.52});
  CHECK(contact_area(deep, slab, near) == Approx(0.01 + 4 * 0.1 * 0.02).epsilon(0.1));
  // A ball of radius r has 2 pi r h within the height h of a plane that it touches.
  CHECK(contact_area(ball({0, 0, 0.4}, 0.1), slab, 0.005) ==
        Approx(2 * pi * 0.1 * 0.005).epsilon(0.25));
  const auto cone = placed(shape::Frustum{0.1, 0.0, 0.5}, Vec3::Zero());
  CHECK(contact_area(cone, slab, near) < 1e-5);
  CHECK(contact_area(box({0, 0, 0}, {0.1, 0.1, 0.1}), slab, near) == 0.0);
  CHECK(contact_area(post, slab, near, {.enough = 0.001}) >= 0.001);
  CHECK(contact_area(slab, post, near, {.within = {{-0.05, -0.05, 0}, {0, 0.05, 1}}}) ==
        Approx(0.005).epsilon(0.1));
}
