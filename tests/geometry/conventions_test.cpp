#include "geometry/conventions.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <string>

#include "catch.h"

using roomgen::axis_conventions;
using roomgen::find_axis_convention;
using Eigen::Vector3d;

namespace {

// What each program's manual says of its own axes.
struct Documented {
  const char* name;
  Vector3d front, up;
  bool right_handed;
  double units_per_metre;
};

const Documented documented[] = {
    {"roomgen", {0, -1, 0}, {0, 0, 1}, true, 1},
    {"blender", {0, -1, 0}, {0, 0, 1}, true, 1},   // right-handed, Z up, front view along +Y
    {"gltf", {0, 0, 1}, {0, 1, 0}, true, 1},       // right-handed, +Y up, the front faces +Z
    {"drake", {0, 1, 0}, {0, 0, 1}, true, 1},      // Z up
    {"habitat", {0, 0, -1}, {0, 1, 0}, true, 1},   // -Z forward, Y up
    {"unity", {0, 0, 1}, {0, 1, 0}, false, 1},     // left-handed, Y up, Z forward
    {"unreal", {1, 0, 0}, {0, 0, 1}, false, 100},  // left-handed, Z up, X forward, centimetres
};

}  // namespace

TEST_CASE("Front and up become the axes that each program documents") {
  for (const auto& program : documented) {
    INFO(program.name);
    const auto* convention = find_axis_convention(program.name);
    REQUIRE(convention);
    CHECK((convention->theirs_from_ours * Vector3d(0, -1, 0) - program.front).norm() < 1e-12);
    CHECK((convention->theirs_from_ours * Vector3d(0, 0, 1) - program.up).norm() < 1e-12);
    CHECK(convention->units_per_metre == program.units_per_metre);
  }
}

TEST_CASE("Only left-handed programs mirror, and no conversion stretches") {
  for (const auto& program : documented) {
    INFO(program.name);
    const auto& m = find_axis_convention(program.name)->theirs_from_ours;
    CHECK(m.determinant() == Approx(program.right_handed ? 1.0 : -1.0));
    CHECK((m * m.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-12);
  }
}

TEST_CASE("A person's right stays a person's right in every program") {
  // Someone who looks along the front has the right hand at our -X. Right-handed programs compute it as
  // front x up, left-handed ones as up x front.
  const Vector3d right(-1, 0, 0);
  for (const auto& program : documented) {
    INFO(program.name);
    const Vector3d theirs = find_axis_convention(program.name)->theirs_from_ours * right;
    const Vector3d cross = program.right_handed ? program.front.cross(program.up)
                                                : program.up.cross(program.front);
    CHECK((theirs - cross).norm() < 1e-12);
  }
}

TEST_CASE("Every convention of the table is documented here, and an unknown name has none") {
  CHECK(axis_conventions().size() == std::size(documented));
  CHECK(find_axis_convention("maya") == nullptr);
}
