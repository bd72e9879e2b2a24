#include "primitive_checks.h"

#include <Eigen/Geometry>

#include "catch.h"

using namespace roomgen;

namespace {

std::string flaw_of(const Mesh& mesh, const Triangle& t) {
  const Vec3 a = mesh.positions[t[0]].cast<double>(), b = mesh.positions[t[1]].cast<double>(),
             c = mesh.positions[t[2]].cast<double>();
  const Vec3 normal = (b - a).cross(c - a);
  if (!(0.5 * normal.norm() >= 1e-12)) return "a triangle has no area";
  for (auto v : t)
    if (!(mesh.normals[v].cast<double>().dot(normal.normalized()) > 0))
      return "a normal looks into its face";
  return "";
}

}  // namespace

std::string flaws(const Mesh& mesh) {
  if (mesh.triangles.empty()) return "is empty";
  if (mesh.normals.size() != mesh.positions.size()) return "normals are missing";
  if (mesh.uvs.size() != mesh.positions.size()) return "uvs are missing";
  for (const auto& normal : mesh.normals)
    if (!(std::abs(normal.norm() - 1.0f) < 1e-4f)) return "a normal has not the length 1";
  for (const auto& uv : mesh.uvs)
    if (!uv.allFinite()) return "a uv is not finite";
  for (const auto& t : mesh.triangles)
    if (auto flaw = flaw_of(mesh, t); !flaw.empty()) return flaw;
  if (!shape::is_closed(mesh)) return "is not closed";
  if (!(shape::volume(mesh) > 0)) return "is inside out";
  return "";
}

Mesh sound(const Result<Mesh>& mesh) {
  INFO((mesh ? "" : mesh.error().message));
  REQUIRE(mesh);
  REQUIRE(flaws(*mesh) == "");
  return *mesh;
}
