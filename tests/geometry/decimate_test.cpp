#include "geometry/decimate.h"

#include "base/random.h"
#include "catch.h"
#include "geometry/mesh_tree.h"

using namespace roomgen;

namespace {

// A wavy sheet of 2 n^2 triangles.
Mesh sheet(int n) {
  Mesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const float x = float(i) / float(n), y = float(j) / float(n);
      mesh.positions.push_back({x, y, 0.1f * std::sin(9 * x) * std::cos(7 * y)});
    }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

Mesh soup(int count) {
  Random random(1);
  Mesh mesh;
  for (int i = 0; i < 3 * count; ++i)
    mesh.positions.push_back(Vec3(random.uniform(), random.uniform(), random.uniform()).cast<float>());
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i)
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  return mesh;
}

}  // namespace

TEST_CASE("A mesh within the bound is returned as it is") {
  const Mesh mesh = sheet(10);
  const Mesh same = decimated(mesh, mesh.triangles.size());
  CHECK(same.positions == mesh.positions);
  CHECK(same.triangles == mesh.triangles);
}

TEST_CASE("A large mesh comes under the bound, keeps most of it and stays in its box") {
  const Mesh mesh = sheet(300);
  for (std::size_t bound : {20000u, 2000u, 200u}) {
    const Mesh coarse = decimated(mesh, bound);
    INFO(bound);
    CHECK(coarse.triangles.size() <= bound);
    CHECK(coarse.triangles.size() >= bound / 6);
    CHECK((bounds(coarse).low - bounds(mesh).low).minCoeff() >= -1e-6);
    CHECK((bounds(mesh).high - bounds(coarse).high).minCoeff() >= -1e-6);
    // What goes is not far from what is left.
    CHECK((bounds(mesh).size() - bounds(coarse).size()).maxCoeff() < 4.0 / std::sqrt(double(bound)));
  }
}

TEST_CASE("The surface stays where it was: no vertex is far from the coarse mesh") {
  const Mesh mesh = sheet(300);
  for (const auto& [bound, most] : {std::pair(20000u, 0.0005), std::pair(2000u, 0.004)}) {
    const MeshTree coarse(decimated(mesh, bound));
    double furthest = 0.0;
    for (const auto& p : mesh.positions)
      furthest = std::max(furthest, (*coarse.closest_point(p.cast<double>()) - p.cast<double>()).norm());
    INFO(bound);
    CHECK(furthest < most);
  }
}

TEST_CASE("Whatever is left is sound: indices in range, no triangle without area") {
  for (const Mesh& mesh : {sheet(150), soup(30000)}) {
    Mesh coarse = decimated(mesh, 5000);
    for (const auto& t : coarse.triangles)
      for (auto v : t) REQUIRE(v < coarse.positions.size());
    CHECK(remove_degenerate(coarse) == 0);
  }
}

TEST_CASE("A soup of triangles across the whole box comes under the bound too") {
  CHECK(decimated(soup(60000), 20000).triangles.size() <= 20000);
}
