#include "columns.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace roomgen::detail {

namespace {

constexpr double pitch = 0.02;
constexpr int most_cells = 400;  // a side
constexpr double rim = 1e-7;     // a line through an edge meets both faces
constexpr double same_place = 5e-4;

int cells(double length) {
  return std::clamp(static_cast<int>(std::ceil(length / pitch)), 1, most_cells);
}

}  // namespace

Columns::Columns(const Mesh& mesh) : box_(bounds(mesh)) {
  if (mesh.triangles.empty()) return;
  const Vec3 size = box_.size();
  nx_ = cells(size.x()), ny_ = cells(size.y());
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]].cast<double>(), b = mesh.positions[t[1]].cast<double>(),
               c = mesh.positions[t[2]].cast<double>();
    const Vec3 normal = (b - a).cross(c - a);
    // Upright faces have no place on a vertical line.
    if (std::abs(normal.z()) < 1e-12 || std::abs(normal.z()) < 1e-4 * normal.norm()) continue;
    faces_.push_back({a, (b - a).head<2>(), (c - a).head<2>(), b.z() - a.z(), c.z() - a.z(),
                      1.0 / normal.z(), normal.z() / normal.norm()});
  }
  const auto column = [&](double x) {
    return std::clamp(static_cast<int>((x - box_.low.x()) / size.x() * nx_), 0, nx_ - 1);
  };
  const auto row = [&](double y) {
    return std::clamp(static_cast<int>((y - box_.low.y()) / size.y() * ny_), 0, ny_ - 1);
  };
  const auto each_cell = [&](const Face& face, const auto& visit) {
    const Vec2 a = face.a.head<2>(), b = a + face.ab, c = a + face.ac;
    const Vec2 low = a.cwiseMin(b).cwiseMin(c).array() - rim;
    const Vec2 high = a.cwiseMax(b).cwiseMax(c).array() + rim;
    for (int j = row(low.y()); j <= row(high.y()); ++j)
      for (int i = column(low.x()); i <= column(high.x()); ++i)
        visit(static_cast<std::size_t>(j * nx_ + i));
  };
  first_.assign(static_cast<std::size_t>(nx_ * ny_) + 1, 0);
  for (const auto& face : faces_) each_cell(face, [&](std::size_t cell) { ++first_[cell + 1]; });
  for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
  faces_of_cells_.resize(first_.back());
  auto next = first_;
  for (std::uint32_t f = 0; f < faces_.size(); ++f)
    each_cell(faces_[f], [&](std::size_t cell) { faces_of_cells_[next[cell]++] = f; });
}

template <typename Visit>
void Columns::visit(const Vec2& at, const Visit& visit) const {
  const Vec3 size = box_.size();
  if (faces_.empty() || ((at - box_.low.head<2>()).array() < -rim).any() ||
      ((box_.high.head<2>() - at).array() < -rim).any())
    return;
  const int i = std::clamp(static_cast<int>((at.x() - box_.low.x()) / size.x() * nx_), 0, nx_ - 1);
  const int j = std::clamp(static_cast<int>((at.y() - box_.low.y()) / size.y() * ny_), 0, ny_ - 1);
  const auto cell = static_cast<std::size_t>(j * nx_ + i);
  for (std::uint32_t k = first_[cell]; k < first_[cell + 1]; ++k) {
    const Face& face = faces_[faces_of_cells_[k]];
    const Vec2 to = at - face.a.head<2>();
    const double v = (to.x() * face.ac.y() - to.y() * face.ac.x()) * face.inverse;
    const double w = (face.ab.x() * to.y() - face.ab.y() * to.x()) * face.inverse;
    if (v < -rim || w < -rim || v + w > 1 + rim) continue;
    visit(Crossing{face.a.z() + v * face.rise_b + w * face.rise_c, face.slope});
  }
}

void Columns::crossings(const Vec2& at, std::vector<Crossing>& found) const {
  found.clear();
  visit(at, [&](const Crossing& crossing) { found.push_back(crossing); });
  std::sort(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) {
    return a.z < b.z || (a.z == b.z && a.slope > b.slope);
  });
  std::size_t kept = 0;
  for (const auto& crossing : found) {
    if (kept > 0 && crossing.z - found[kept - 1].z < same_place) {
      if (crossing.slope > found[kept - 1].slope) found[kept - 1] = crossing;
    } else {
      found[kept++] = crossing;
    }
  }
  found.resize(kept);
}

std::optional<double> Columns::highest(const Vec2& at, double low, double high) const {
  std::optional<double> best;
  visit(at, [&](const Crossing& crossing) {
    if (crossing.z >= low && crossing.z <= high && (!best || crossing.z > *best)) best = crossing.z;
  });
  return best;
}

std::optional<double> Columns::lowest(const Vec2& at) const {
  std::optional<double> best;
  visit(at, [&](const Crossing& crossing) {
    if (!best || crossing.z < *best) best = crossing.z;
  });
  return best;
}

}  // namespace roomgen::detail
