#include "roomgen/geometry/model.h"

#include <Eigen/Geometry>
#include <limits>

#include "base/random.h"
#include "catch.h"
#include "geometry/centroid.h"

using namespace roomgen;
using Eigen::Vector3f;

namespace {

Vector3f face_normal(const Mesh& mesh, const Triangle& t) {
  return (mesh.positions[t[1]] - mesh.positions[t[0]])
      .cross(mesh.positions[t[2]] - mesh.positions[t[0]])
      .normalized();
}

// The volume enclosed, by the divergence theorem; positive when triangles face outward.
double volume(const Mesh& mesh) {
  double six = 0.0;
  for (const auto& t : mesh.triangles)
    six += static_cast<double>(
        mesh.positions[t[0]].dot(mesh.positions[t[1]].cross(mesh.positions[t[2]])));
  return six / 6.0;
}

Mesh shared_corner_box() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back({float(i & 1), float(i >> 1 & 1), float(i >> 2 & 1)});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

Mesh sphere(int rings, int steps) {
  Mesh mesh;
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j <= steps; ++j) {
      const double a = pi * i / rings, b = 2 * pi * j / steps;
      mesh.positions.push_back(
          Vec3(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)).cast<float>());
    }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i * (steps + 1) + j); };
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < steps; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

}  // namespace

TEST_CASE("A box encloses its volume, faces outward and has flat normals") {
  const Mesh box = make_box({-1, 0, 2}, {1, 3, 2.5});
  CHECK(volume(box) == Approx(2 * 3 * 0.5));
  CHECK(bounds(box).low == Vec3(-1, 0, 2));
  CHECK(bounds(box).high == Vec3(1, 3, 2.5));
  for (const auto& t : box.triangles)
    for (auto v : t) CHECK(face_normal(box, t).dot(box.normals[v]) == Approx(1.0));
}

TEST_CASE("Every kind of bad triangle goes and the good ones stay") {
  Mesh mesh = shared_corner_box();
  const auto good = mesh.triangles;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto count = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back({nan, 0, 0});
  mesh.positions.push_back({0.5f, 0, 0});  // in line with corners 0 and 1
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({0, 1, 999999});
  mesh.triangles.push_back({0, 1, count});
  mesh.triangles.push_back({0, 1, count + 1});
  CHECK(remove_degenerate(mesh) == 4);
  CHECK(mesh.triangles == good);
  CHECK(mesh.positions.size() == 8);
  CHECK(remove_degenerate(mesh) == 0);
}

TEST_CASE("A mesh of bad triangles only becomes empty") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}};
  mesh.triangles = {{0, 1, 1}, {7, 8, 9}};
  CHECK(remove_degenerate(mesh) == 2);
  CHECK(mesh.triangles.empty());
  CHECK(mesh.positions.empty());
  CHECK(bounds(mesh).empty());
  CHECK(remove_degenerate(mesh) == 0);
  repair_normals(mesh);
  CHECK(mesh.normals.empty());
}

TEST_CASE("Attributes stay with their vertices when others go") {
  Mesh mesh = make_box({0, 0, 0}, {1, 1, 1});
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 6);
  const Mesh before = mesh;
  remove_degenerate(mesh);
  REQUIRE(mesh.positions.size() < before.positions.size());
  REQUIRE(mesh.normals.size() == mesh.positions.size());
  REQUIRE(mesh.uvs.size() == mesh.positions.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (int corner = 0; corner < 3; ++corner) {
      const auto now = mesh.triangles[i][corner], then = before.triangles[i][corner];
      CHECK(mesh.positions[now] == before.positions[then]);
      CHECK(mesh.normals[now] == before.normals[then]);
      CHECK(mesh.uvs[now] == before.uvs[then]);
    }
}

TEST_CASE("Normals of the wrong number are dropped rather than read past their end") {
  Mesh mesh = make_box({0, 0, 0}, {1, 1, 1});
  mesh.normals.resize(3);
  mesh.uvs.resize(5);
  remove_degenerate(mesh);
  CHECK(mesh.normals.empty());
  CHECK(mesh.uvs.empty());
}

TEST_CASE("A box that shares its corners gets a flat normal on each face") {
  Mesh mesh = shared_corner_box();
  const double before = volume(mesh);
  repair_normals(mesh);
  CHECK(mesh.positions.size() >= 24);
  CHECK(mesh.positions.size() <= 36);
  CHECK(volume(mesh) == Approx(before));
  for (const auto& t : mesh.triangles)
    for (auto v : t) CHECK(face_normal(mesh, t).dot(mesh.normals[v]) == Approx(1.0));
}

TEST_CASE("A sphere gets smooth normals that point outward") {
  Mesh mesh = sphere(24, 32);
  remove_degenerate(mesh);
  const auto vertices = mesh.positions.size();
  repair_normals(mesh);
  CHECK(mesh.positions.size() == vertices);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    CHECK(mesh.normals[v].dot(mesh.positions[v].normalized()) > 0.99f);
}

TEST_CASE("Good normals are left alone and broken ones become unit vectors") {
  Mesh mesh = make_box({0, 0, 0}, {1, 1, 1});
  const Mesh before = mesh;
  repair_normals(mesh);
  CHECK(mesh.normals == before.normals);
  mesh.normals[3] = Vector3f::Zero();
  mesh.normals[9] = Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  repair_normals(mesh);
  REQUIRE(mesh.normals.size() == mesh.positions.size());
  for (const auto& t : mesh.triangles)
    for (auto v : t) CHECK(face_normal(mesh, t).dot(mesh.normals[v]) == Approx(1.0));
}

TEST_CASE("An appended mesh is scaled and moved, and keeps unit normals") {
  Mesh mesh = make_box({0, 0, 0}, {1, 1, 1});
  append(mesh, make_box({0, 0, 0}, {1, 1, 1}), {2, 3, 4}, {10, 0, 0});
  CHECK(mesh.triangles.size() == 24);
  CHECK(volume(mesh) == Approx(1 + 24));
  CHECK(bounds(mesh).high == Vec3(12, 3, 4));
  for (const auto& t : mesh.triangles)
    for (auto v : t) CHECK(face_normal(mesh, t).dot(mesh.normals[v]) == Approx(1.0));
}

TEST_CASE("The centroid of a surface does not depend on how finely it is cut") {
  Mesh mesh = make_box({0, 0, 0}, {2, 4, 6});
  CHECK((surface_centroid(mesh) - Vec3(1, 2, 3)).norm() == Approx(0.0).margin(1e-6));
  const auto [a, b, c] = mesh.triangles.back();
  const auto middle = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back((mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.0f);
  mesh.triangles.pop_back();
  for (const Triangle& t : {Triangle{a, b, middle}, Triangle{b, c, middle}, Triangle{c, a, middle}})
    mesh.triangles.push_back(t);
  CHECK((surface_centroid(mesh) - Vec3(1, 2, 3)).norm() == Approx(0.0).margin(1e-6));
  CHECK(surface_centroid(Mesh()) == Vec3(Vec3::Zero()));
}
