#include "frame.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "roomgen/base/text.h"

namespace roomgen::assets {

namespace {

constexpr double flat = 1e-6;      // metres: thinner has no thickness to be scaled
constexpr double thinnest = 1e-3;  // what such a thing is said to measure
constexpr double smallest = 1e-6, greatest = 1000.0;
constexpr int max_passes = 4;
constexpr double min_area = 1e-10;  // square metres

std::optional<Vec3> axis(const std::string& text) {
  if (text.size() != 2 || (text[0] != '+' && text[0] != '-')) return std::nullopt;
  const int index = text[1] - 'x';
  if (index < 0 || index > 2) return std::nullopt;
  Vec3 result = Vec3::Zero();
  result[index] = text[0] == '+' ? 1.0 : -1.0;
  return result;
}

// Furniture is between 2 cm and 20 m: whatever unit makes it so.
double guess_metres_per_unit(double longest) {
  if (longest > 2000.0) return 0.001;
  if (longest > 20.0) return 0.01;
  return 1.0;
}

void transform(Model& model, const Eigen::Matrix3d& linear, const Vec3& offset) {
  const Eigen::Matrix3d of_normals = linear.inverse().transpose();
  for (auto& part : model.parts) {
    for (auto& p : part.mesh.positions) p = (linear * p.cast<double>() + offset).cast<float>();
    for (auto& n : part.mesh.normals) {
      const Vec3 turned = of_normals * n.cast<double>();
      const double length = turned.norm();
      n = length > 1e-12 ? Eigen::Vector3f((turned / length).cast<float>())
                         : Eigen::Vector3f::Zero();
    }
    if (linear.determinant() < 0.0)
      for (auto& t : part.mesh.triangles) std::swap(t[1], t[2]);
  }
}

std::size_t drop_degenerate(Model& model, double area) {
  std::size_t dropped = 0;
  for (auto& part : model.parts) dropped += remove_degenerate(part.mesh, area);
  std::erase_if(model.parts, [](const ModelPart& part) { return part.mesh.triangles.empty(); });
  return dropped;
}

// Rounding to float must not put a vertex outside the box.
void clamp_to_box(Model& model, const Vec3& size) {
  const Eigen::Vector3f low = Vec3(-0.5 * size.x(), -0.5 * size.y(), 0.0).cast<float>();
  const Eigen::Vector3f high = Vec3(0.5 * size.x(), 0.5 * size.y(), size.z()).cast<float>();
  for (auto& part : model.parts)
    for (auto& p : part.mesh.positions) p = p.cwiseMax(low).cwiseMin(high);
}

// Scales and moves the model to the wanted box, else only moves it; returns the box. An axis
// without thickness stays as it is.
Vec3 fit_box(Model& model, const std::optional<Vec3>& wanted) {
  const Bounds3 box = bounds(model);
  Vec3 scale = Vec3::Ones(), size = box.size();
  for (int i = 0; i < 3; ++i) {
    if (size[i] <= flat) {
      size[i] = thinnest;
    } else if (wanted) {
      scale[i] = (*wanted)[i] / size[i];
      size[i] = (*wanted)[i];
    }
  }
  const Vec3 origin(box.center().x(), box.center().y(), box.low.z());
  transform(model, scale.asDiagonal(), -origin.cwiseProduct(scale));
  clamp_to_box(model, size);
  return size;
}

}  // namespace

Result<Eigen::Matrix3d> ours_from_axes(const std::string& up, const std::string& front) {
  const auto z = axis(lower(up)), ahead = axis(lower(front));
  if (!z || !ahead || std::abs(z->dot(*ahead)) > 0.5)
    return Error{Error::Kind::invalid_input,
                 "up \"" + up + "\" and front \"" + front +
                     "\" must be two of +x, -x, +y, -y, +z, -z that are not parallel"};
  const Vec3 y = -*ahead;
  Eigen::Matrix3d rows;
  rows.row(0) = y.cross(*z).transpose();
  rows.row(1) = y.transpose();
  rows.row(2) = z->transpose();
  return rows;
}

Result<Vec3> fit_to_frame(Model& model, const SourceFrame& frame, Normals normals) {
  drop_degenerate(model, 0.0);  // what is not finite would spoil the box
  transform(model, frame.ours_from_source, Vec3::Zero());
  double longest = bounds(model).size().maxCoeff();
  if (!(longest > 0.0) || !std::isfinite(longest))
    return Error{Error::Kind::invalid_input, "has no extent"};
  double unit =
      frame.metres_per_unit > 0.0 ? frame.metres_per_unit : guess_metres_per_unit(longest);
  if (frame.size) unit = frame.size->maxCoeff() / longest;
  transform(model, Eigen::Matrix3d::Identity() * unit, Vec3::Zero());

  // Rounding after a step may flatten a triangle, and one that goes may have been at the edge.
  Vec3 size = Vec3::Zero();
  for (int pass = 0; pass < max_passes; ++pass) {
    const std::size_t dropped = drop_degenerate(model, min_area);
    if (model.parts.empty()) return Error{Error::Kind::invalid_input, "has no triangles"};
    if (pass > 0 && dropped == 0) break;
    size = fit_box(model, frame.size);
    if (size.maxCoeff() > greatest)
      return Error{Error::Kind::invalid_input, "is larger than 1000 m; say its size or its units (docs/assets.md)"};
    if (!(size.minCoeff() > smallest)) return Error{Error::Kind::invalid_input, "has no extent"};
  }
  if (normals == Normals::repair)
    for (auto& part : model.parts) repair_normals(part.mesh);
  return size;
}

}  // namespace roomgen::assets
