#include "geometry/facet.h"

#include <Eigen/Geometry>

#include "catch.h"
#include "support/random_mesh.h"

using namespace roomgen;

namespace {

Vec3 point_of(const Facet& facet, double u, double v) {
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return facet.a + u * (facet.b - facet.a) + v * (facet.c - facet.a);
}

bool is_on(const Facet& facet, const Vec3& point) {
  return (closest_point(facet, point) - point).norm() < 1e-9;
}

// Goes to and fro between the nearest points, which for convex sets ends at the distance.
double distance_by_projection(const Facet& a, const Facet& b) {
  Vec3 on_a = (a.a + a.b + a.c) / 3, on_b = Vec3::Zero();
  for (int step = 0; step < 20000; ++step) {
    on_b = closest_point(b, on_a);
    const Vec3 next = closest_point(a, on_b);
    if ((next - on_a).norm() < 1e-12) break;
    on_a = next;
  }
  return (on_a - on_b).norm();
}

}  // namespace

TEST_CASE("No sampled point of a facet is nearer than its closest point, which lies on it") {
  Random random(1);
  for (int n = 0; n < 2000; ++n) {
    const Facet facet = shapes::random_facet(random, 1);
    const Vec3 point = shapes::random_place(random, -3, 3);
    const Vec3 closest = closest_point(facet, point);
    REQUIRE(is_on(facet, closest));
    const double least = (closest - point).norm();
    for (int k = 0; k < 30; ++k)
      REQUIRE((point_of(facet, random.uniform(), random.uniform()) - point).norm() > least - 1e-9);
  }
}

TEST_CASE("A ray to a point of a facet crosses it there, one past it does not") {
  Random random(2);
  for (int n = 0; n < 2000; ++n) {
    const Facet facet = shapes::random_facet(random, 1);
    const Vec3 normal = (facet.b - facet.a).cross(facet.c - facet.a);
    if (normal.norm() < 1e-3) continue;
    const double u = random.uniform(0.05, 0.45), v = random.uniform(0.05, 0.45);
    const Vec3 origin = shapes::random_place(random, -3, 3), target = point_of(facet, u, v);
    if (std::abs(normal.normalized().dot(target - origin)) < 1e-3) continue;
    const auto met = crossing(facet, {origin, target - origin});
    REQUIRE(met);
    CHECK(met->at == Approx(1.0));
    CHECK(met->outward == (normal.dot(target - origin) > 0));
    const Vec3 beside = facet.a - u * (facet.b - facet.a) + v * (facet.c - facet.a);
    CHECK_FALSE(crossing(facet, {origin, beside - origin}));
  }
}

TEST_CASE("The nearest points of two facets are theirs and as near as going to and fro finds") {
  Random random(3);
  int meeting = 0, apart = 0;
  for (int n = 0; n < 3000; ++n) {
    const Facet a = shapes::random_facet(random, 2), b = shapes::random_facet(random, 2);
    const auto nearest = nearest_points(a, b);
    INFO("pair " << n);
    REQUIRE(is_on(a, nearest.on_a));
    REQUIRE(is_on(b, nearest.on_b));
    REQUIRE((nearest.on_a - nearest.on_b).norm() == Approx(nearest.distance).margin(1e-9));
    const double other = distance_by_projection(a, b);
    REQUIRE(nearest.distance < other + 1e-9);
    REQUIRE(nearest.distance > other - 1e-3);  // where facets nearly meet it comes close slowly
    (nearest.distance == 0.0 ? meeting : apart) += 1;
  }
  CHECK(meeting > 100);
  CHECK(apart > 1000);
}

TEST_CASE("Facets in one plane that overlap, and those that share a corner, are at distance 0") {
  const Facet large{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, inner{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}};
  CHECK(nearest_points(large, inner).distance == 0.0);
  CHECK(nearest_points(inner, large).distance == 0.0);
  CHECK(nearest_points(large, {{4, 0, 0}, {5, 0, 1}, {5, 1, 0}}).distance == 0.0);
  CHECK(nearest_points(large, {{1, 1, -1}, {1, 1, 1}, {1, 2, 1}}).distance == 0.0);
  CHECK(nearest_points(large, {{1, 1, 0.25}, {1, 1, 1}, {1, 2, 1}}).distance == Approx(0.25));
}
