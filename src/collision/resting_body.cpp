#include "resting_body.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/centroid.h"
#include "geometry/convex_hull.h"
#include "scene/box_model.h"
#include "sized_mesh.h"

namespace roomgen::detail {

namespace {

constexpr double low_part = 0.06;  // of an object that may touch a curved top
constexpr double hull_slack = 0.002;

bool is_upright(const Mesh& mesh, const Triangle& t) {
  const Vec3 a = mesh.positions[t[0]].cast<double>(), b = mesh.positions[t[1]].cast<double>(),
             c = mesh.positions[t[2]].cast<double>();
  const Vec3 normal = (b - a).cross(c - a);
  return std::abs(normal.z()) < 0.5 * normal.norm();
}

Underside underside_of(const Mesh& mesh, const Columns& columns) {
  Underside underside;
  underside.centroid = surface_centroid(mesh).head<2>();
  const Vec3 size = columns.box().size();
  const double step = std::clamp(size.head<2>().maxCoeff() / 24.0, 0.004, 0.03);
  const int nx = std::max(2, static_cast<int>(size.x() / step));
  const int ny = std::max(2, static_cast<int>(size.y() / step));
  const Vec2 low = columns.box().low.head<2>();
  const Vec2 cell(size.x() / nx, size.y() / ny);
  const double bottom = columns.box().low.z();
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const Vec2 at = low + Vec2((i + 0.5) * cell.x(), (j + 0.5) * cell.y());
      const auto z = columns.lowest(at);
      if (z && *z < bottom + low_part) underside.points.push_back({at.x(), at.y(), *z - bottom});
    }
  // What the grid misses: the lowest vertex of each of its cells.
  std::map<std::pair<int, int>, Vec3> lowest;
  for (const auto& p : mesh.positions) {
    if (p.z() > bottom + low_part) continue;
    const Vec3 point(p.x(), p.y(), p.z() - bottom);
    const std::pair<int, int> key(static_cast<int>((p.x() - low.x()) / cell.x()),
                                  static_cast<int>((p.y() - low.y()) / cell.y()));
    const auto [at, is_new] = lowest.try_emplace(key, point);
    if (!is_new && point.z() < at->second.z()) at->second = point;
  }
  for (const auto& [key, point] : lowest) underside.points.push_back(point);
  std::vector<Vec2> contacts;
  for (const auto& p : underside.points)
    if (p.z() <= touching) contacts.push_back(p.head<2>());
  underside.stands = is_over(underside.centroid, contacts);
  return underside;
}

}  // namespace

bool is_over(const Vec2& point, std::vector<Vec2> contacts) {
  const auto hull = convex_hull(std::move(contacts));
  return hull.size() >= 3 && depth_in(hull, point) >= -hull_slack;
}

const std::vector<SupportSurface>& RestingBody::surfaces() {
  if (!surfaces_)
    surfaces_ = object_.traits.flat ? std::vector<SupportSurface>{}
                                    : support_surfaces(without_panes());
  return *surfaces_;
}

const Columns& RestingBody::columns() {
  if (!columns_) columns_.emplace(mesh());
  return *columns_;
}

const Underside& RestingBody::underside() {
  if (!underside_) underside_ = underside_of(mesh(), columns());
  return *underside_;
}

const Mesh& RestingBody::mesh() {
  if (!mesh_) mesh_ = sized_mesh(object_, models_);
  return *mesh_;
}

// Without upright panes: what is behind the glass of a cabinet is seen, and its doors open.
Mesh RestingBody::without_panes() const {
  Model open = *model_or_box(object_, models_);
  const Vec3 scale = model_placement(object_, bounds(open)).scale;
  for (auto& part : open.parts)
    if (open.materials[static_cast<std::size_t>(part.material)].transparent())
      std::erase_if(part.mesh.triangles, [&](const auto& t) { return is_upright(part.mesh, t); });
  Mesh mesh;
  append(mesh, merged_mesh(open), scale);
  return mesh;
}

}  // namespace roomgen::detail
