#include "low_parts.h"

#include <array>

#include "geometry/facet.h"
#include "sized_mesh.h"

namespace roomgen {

namespace {

constexpr double part_gap = 0.01;     // parts that are nearer to each other are one
constexpr std::size_t most_parts = 24;  // more are a grille: taken as one

// The part of a triangle under the height, seen from above.
Bounds2 below(const Facet& triangle, double height) {
  const std::array<Vec3, 3> corners = {triangle.a, triangle.b, triangle.c};
  Bounds2 box;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &from = corners[i], &to = corners[(i + 1) % 3];
    if (from.z() < height) box.add(from.head<2>());
    if ((from.z() < height) == (to.z() < height)) continue;
    const double t = (height - from.z()) / (to.z() - from.z());
    box.add((from + t * (to - from)).head<2>());
  }
  return box;
}

void merge(const Bounds2& other, Bounds2& box) {
  box.add(other.low);
  box.add(other.high);
}

// Adds a box; what it touches becomes one with it.
void add_part(Bounds2 box, std::vector<Bounds2>& parts) {
  for (std::size_t i = 0; i < parts.size();) {
    if (!parts[i].overlaps(box, part_gap)) {
      ++i;
      continue;
    }
    merge(parts[i], box);
    parts[i] = parts.back();
    parts.pop_back();
    i = 0;  // the larger box may touch what the smaller one did not
  }
  parts.push_back(box);
}

std::vector<Bounds2> boxes_below(const Mesh& mesh, double height) {
  std::vector<Bounds2> parts;
  for (const auto& t : mesh.triangles)
    if (const Bounds2 box = below(facet(mesh, t), height); box.low.x() <= box.high.x())
      add_part(box, parts);
  if (parts.size() <= most_parts) return parts;
  for (std::size_t i = 1; i < parts.size(); ++i) merge(parts[i], parts.front());
  parts.resize(1);
  return parts;
}

}  // namespace

std::vector<Footprint> low_parts(const Object& object, const ModelTable& models, double height) {
  if (bottom(object) >= height) return {};
  const Footprint own = footprint(object);
  std::vector<Footprint> parts;
  for (const auto& box : boxes_below(detail::sized_mesh(object, models), height - bottom(object)))
    parts.emplace_back(own.to_world(0.5 * (box.low + box.high)), box.size(), object.yaw);
  return parts;
}

}  // namespace roomgen
