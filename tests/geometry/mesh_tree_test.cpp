// The tree against looking at every triangle, on meshes without any order.
#include "geometry/mesh_tree.h"

#include "catch.h"
#include "support/random_mesh.h"

using namespace roomgen;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double nearest_by_search(const Mesh& mesh, const Vec3& point) {
  double best = infinite;
  for (const auto& t : mesh.triangles)
    best = std::min(best, (closest_point(facet(mesh, t), point) - point).norm());
  return best;
}

double first_hit_by_search(const Mesh& mesh, const Ray& ray) {
  double best = infinite;
  for (const auto& t : mesh.triangles)
    if (const auto met = crossing(facet(mesh, t), ray, 1e-9); met && met->at >= -1e-6)
      best = std::min(best, met->at);
  return std::max(best, 0.0);
}

double distance_by_search(const Mesh& a, const Mesh& b) {
  double best = infinite;
  for (const auto& s : a.triangles)
    for (const auto& t : b.triangles)
      best = std::min(best, nearest_points(facet(a, s), facet(b, t)).distance);
  return best;
}

}  // namespace

TEST_CASE("The closest point is the one that looking at all triangles finds") {
  Random random(1);
  for (int n = 0; n < 40; ++n) {
    const Mesh mesh = shapes::random_soup(random, random.integer(1, 400), 0.4);
    const MeshTree tree(mesh);
    for (int k = 0; k < 50; ++k) {
      const Vec3 point = shapes::random_place(random, -4, 4);
      const double expected = nearest_by_search(mesh, point);
      const auto found = tree.closest_point(point);
      REQUIRE(found);
      REQUIRE((*found - point).norm() == Approx(expected).margin(1e-12));
      REQUIRE_FALSE(tree.closest_point(point, expected * (1 - 1e-9)));
      REQUIRE(tree.within(point, expected * (1 + 1e-9)));
      REQUIRE_FALSE(tree.within(point, expected * (1 - 1e-9)));
    }
  }
}

TEST_CASE("A ray meets the triangle that looking at all of them finds, in any direction") {
  Random random(2);
  int hits = 0;
  for (int n = 0; n < 40; ++n) {
    const Mesh mesh = shapes::random_soup(random, random.integer(1, 400), 0.6);
    const MeshTree tree(mesh);
    for (int k = 0; k < 100; ++k) {
      Ray ray{shapes::random_place(random, -3, 3), shapes::random_place(random, -1, 1)};
      if (random.chance(0.3)) ray.direction = Vec3::Unit(random.integer(0, 2));
      const double expected = first_hit_by_search(mesh, ray);
      const auto found = tree.first_hit(ray);
      REQUIRE(found.has_value() == (expected < infinite));
      if (!found) continue;
      ++hits;
      REQUIRE(*found == Approx(expected).margin(1e-12));
    }
  }
  CHECK(hits > 500);
}

TEST_CASE("A ray that starts on a surface meets it there") {
  const MeshTree box(make_box({0, 0, 0}, {1, 1, 1}));
  CHECK(box.first_hit({{0.5, 0.5, 1.0}, {0, 0, -1}}).value() == Approx(0.0));
  CHECK(box.first_hit({{0.5, 0.5, 2.0}, {0, 0, -1}}).value() == Approx(1.0));
  CHECK_FALSE(box.first_hit({{0.5, 0.5, 2.0}, {0, 0, 1}}));
}

TEST_CASE("What is around a point are the boxes that hold it") {
  Random random(3);
  for (int n = 0; n < 30; ++n) {
    Mesh mesh;
    std::vector<Bounds3> boxes;
    for (int k = random.integer(1, 30); k > 0; --k) {
      const Vec3 low = shapes::random_place(random, -2, 1);
      boxes.push_back({low, low + shapes::random_place(random, 0.1, 1.5)});
      append(mesh, make_box(boxes.back().low, boxes.back().high));
    }
    const MeshTree tree(mesh);
    for (int k = 0; k < 100; ++k) {
      const Vec3 point = shapes::random_place(random, -2, 2);
      int holding = 0;
      for (const auto& box : boxes)
        holding += (point.array() > box.low.array()).all() && (point.array() < box.high.array()).all();
      const Enclosure around = tree.around(point);
      REQUIRE(around.winding == holding);
      REQUIRE(around.crossings % 2 == holding % 2);
    }
  }
}

TEST_CASE("Two trees are as far apart as the nearest pair of their triangles") {
  Random random(4);
  int meeting = 0, apart = 0;
  for (int n = 0; n < 120; ++n) {
    const double size = random.uniform(0.05, 0.6);
    const Mesh a = shapes::random_soup(random, random.integer(1, 60), size);
    Mesh b = shapes::random_soup(random, random.integer(1, 60), size);
    const auto away = static_cast<float>(random.uniform(0, 3));
    for (auto& p : b.positions) p.x() += away;
    const double expected = distance_by_search(a, b);
    NearestPoints nearest;
    nearest.distance = infinite;
    REQUIRE(MeshTree(a).nearest(MeshTree(b), nearest));
    REQUIRE(nearest.distance == Approx(expected).margin(1e-12));
    (expected == 0.0 ? meeting : apart) += 1;
    if (expected == 0.0) continue;
    nearest.distance = expected * (1 - 1e-9);
    REQUIRE_FALSE(MeshTree(a).nearest(MeshTree(b), nearest));
  }
  CHECK(meeting > 10);
  CHECK(apart > 30);
}

TEST_CASE("A mesh without triangles is near nothing and around nothing") {
  const MeshTree none{Mesh()}, box(make_box({0, 0, 0}, {1, 1, 1}));
  NearestPoints nearest;
  nearest.distance = infinite;
  CHECK(none.empty());
  CHECK_FALSE(none.closest_point({0, 0, 0}));
  CHECK_FALSE(none.first_hit({}));
  CHECK_FALSE(none.nearest(box, nearest));
  CHECK_FALSE(box.nearest(none, nearest));
  CHECK(none.around({0, 0, 0}).crossings == 0);
}
