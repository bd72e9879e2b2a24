#include "placing.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "component_reader.h"

namespace roomgen::shape::detail {

namespace {

void place(std::vector<Body>& bodies, const Placement& by) {
  for (auto& body : bodies) detail::place(body.mesh, by);
}

Bounds3 box_of(const Copies& copies) {
  Bounds3 box;
  for (const auto& bodies : copies)
    for (const auto& body : bodies)
      for (const auto& p : body.mesh.positions) box.add(p.cast<double>());
  return box;
}

// Copy k is every body so far, placed by placements[k].
void repeat(Copies& copies, const std::vector<Placement>& placements) {
  Copies result;
  for (const auto& by : placements)
    for (const auto& bodies : copies) {
      result.push_back(bodies);
      place(result.back(), by);
    }
  copies = std::move(result);
}

void move(Copies& copies, const Vec3& by) {
  for (auto& bodies : copies) place(bodies, {Eigen::Matrix3d::Identity(), by});
}

struct Applied {
  Copies& copies;

  void operator()(const Cut&) const {}
  void operator()(const Mirror& mirror) const {
    repeat(copies, {Placement{}, detail::mirror(mirror.axis)});
  }
  void operator()(const Array& array) const {
    std::vector<Placement> placements;
    for (int k = 0; k < array.count; ++k)
      placements.push_back({Eigen::Matrix3d::Identity(), k * array.step});
    repeat(copies, placements);
  }
  void operator()(const Radial& radial) const {
    std::vector<Placement> placements;
    for (int k = 0; k < radial.count; ++k)
      placements.push_back(turn(radial.center, copy_angle(radial, k, radial.count)));
    repeat(copies, placements);
  }
  void operator()(const Center& center) const {
    const Bounds3 box = box_of(copies);
    if (box.empty()) return;
    const Vec3 chosen(center.x, center.y, center.z);
    move(copies, -box.center().cwiseProduct(chosen));
  }
  void operator()(const Ground&) const {
    const Bounds3 box = box_of(copies);
    if (!box.empty()) move(copies, {0, 0, -box.low.z()});
  }
  void operator()(const Join&) const {
    std::vector<Body> joined;
    for (auto& bodies : copies)
      for (auto& body : bodies) {
        const auto same = std::find_if(joined.begin(), joined.end(),
                                       [&](const Body& b) { return b.material == body.material; });
        if (same == joined.end())
          joined.push_back(std::move(body));
        else
          append_mesh(same->mesh, body.mesh);
      }
    for (auto& body : joined) body.name.clear();
    copies = {std::move(joined)};
  }
};

}  // namespace

void append_mesh(Mesh& mesh, const Mesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
  mesh.uvs.insert(mesh.uvs.end(), other.uvs.begin(), other.uvs.end());
  for (const auto& t : other.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

Placement placement(const Component& component) {
  const Eigen::Matrix3d rotation = (Eigen::AngleAxisd(component.rotate.z(), Vec3::UnitZ()) *
                                    Eigen::AngleAxisd(component.rotate.y(), Vec3::UnitY()) *
                                    Eigen::AngleAxisd(component.rotate.x(), Vec3::UnitX()))
                                       .toRotationMatrix();
  return {rotation * component.scale.asDiagonal(), component.at};
}

Placement turn(const Vec2& center, double angle) {
  Placement result;
  result.linear = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
  const Vec3 axis(center.x(), center.y(), 0.0);
  result.offset = axis - result.linear * axis;
  return result;
}

Placement mirror(int axis) {
  Placement result;
  result.linear(axis, axis) = -1.0;
  return result;
}

void place(Mesh& mesh, const Placement& placement) {
  const double determinant = placement.linear.determinant();
  const Eigen::Matrix3d for_normals = placement.linear.inverse().transpose();
  for (auto& p : mesh.positions)
    p = (placement.linear * p.cast<double>() + placement.offset).cast<float>();
  for (auto& n : mesh.normals) n = (for_normals * n.cast<double>()).normalized().cast<float>();
  if (determinant < 0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  const auto scale = static_cast<float>(std::cbrt(std::abs(determinant)));
  if (std::abs(scale - 1.0f) > 1e-6f)
    for (auto& uv : mesh.uvs) uv *= scale;
}

void apply(const Operation& operation, Copies& copies) {
  std::visit(Applied{copies}, operation);
}

}  // namespace roomgen::shape::detail
