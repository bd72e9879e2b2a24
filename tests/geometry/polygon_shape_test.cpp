#include "catch.h"
#include "geometry/triangulate.h"
#include "roomgen/geometry/polygon.h"
#include "support/shapes.h"

using namespace roomgen;

namespace {

double triangle_area(const Polygon& polygon, const std::array<std::uint32_t, 3>& t) {
  const auto& p = polygon.points;
  return 0.5 * cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
}

}  // namespace

TEST_CASE("Triangles cover a polygon once: their areas add up and each point is in one") {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const auto polygon = shapes::random_star(random, {0, 0}, 0.6, 4, random.integer(3, 14));
    const auto triangles = triangulate(polygon);
    REQUIRE(triangles.size() == polygon.size() - 2);
    double sum = 0.0;
    for (const auto& t : triangles) {
      REQUIRE(triangle_area(polygon, t) > -1e-12);
      sum += triangle_area(polygon, t);
    }
    REQUIRE(sum == Approx(area(polygon)));
    for (int j = 0; j < 20; ++j) {
      const Vec2 p = shapes::random_point(random, -3, 3);
      int covered = 0;
      for (const auto& t : triangles)
        covered += shapes::winds_around({polygon.points[t[0]], polygon.points[t[1]],
                                         polygon.points[t[2]]}, p)
                       ? 1
                       : 0;
      REQUIRE(covered == (shapes::winds_around(polygon.points, p) ? 1 : 0));
    }
  }
}

TEST_CASE("A comb is triangulated") {
  //  +-+ +-+ +-+ +-+
  //  | | | | | | | |
  //  | +-+ +-+ +-+ |
  //  +-------------+
  Polygon comb{{{0, 0}, {9, 0}}};
  for (int tooth = 4; tooth >= 0; --tooth) {
    comb.points.push_back({2.0 * tooth + 1, 3});
    comb.points.push_back({2.0 * tooth, 3});
    if (tooth > 0) {
      comb.points.push_back({2.0 * tooth, 1});
      comb.points.push_back({2.0 * tooth - 1, 1});
    }
  }
  double sum = 0.0;
  for (const auto& t : triangulate(comb)) sum += triangle_area(comb, t);
  CHECK(sum == Approx(area(comb)));
  CHECK(sum == Approx(9 + 5 * 2));
}

TEST_CASE("Every wall's outer face is as far from its inner face as asked") {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    // Not so spiky that the limit on mitres matters.
    const auto polygon = shapes::random_star(random, {0, 0}, 3, 4, random.integer(4, 9));
    const double distance = random.uniform(0.01, 0.2);
    const auto outer = offset_outward(polygon, distance);
    REQUIRE(outer.size() == polygon.size());
    for (std::size_t k = 0; k < outer.size(); ++k) {
      const Vec2 outward = -polygon.inward(k);
      REQUIRE((outer[k] - polygon.points[k]).dot(outward) == Approx(distance));
      REQUIRE((outer[(k + 1) % outer.size()] - polygon.points[k]).dot(outward) == Approx(distance));
    }
    REQUIRE(signed_area(outer) > area(polygon));
  }
}

TEST_CASE("A needle-sharp corner does not send its outer corner far away") {
  const Polygon needle{{{0, 0}, {10, 0.02}, {10, 0.04}}};
  for (const auto& p : offset_outward(needle, 0.1)) CHECK((p - Vec2(5, 0)).norm() < 8.0);
}
