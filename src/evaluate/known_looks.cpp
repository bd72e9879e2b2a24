#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "attributes.h"
#include "library/seen_assets.h"
#include "roomgen/base/text.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen {

namespace {

constexpr double least_surface = 1.0 / 7.0;
constexpr float metallic_from = 0.5f;

void add_words(const std::string& text, std::set<std::string>& to) {
  for (auto& word : words(text)) to.insert(singular(word));
}

void look_at_surfaces(const Model& model, KnownLooks& looks) {
  std::map<std::string, double> areas, rough_areas, drawn_areas, clear_areas;
  double whole = 0.0, rough = 0.0;
  for (const auto& part : model.parts) {
    const Material& material = model.materials[static_cast<std::size_t>(part.material)];
    const double covered = surface_area(part.mesh);
    whole += covered;
    rough += covered * material.roughness;
    std::set<std::string> names;
    add_words(material.name, names);
    if (material.transparent()) names.insert("glass");
    if (material.metallic >= metallic_from) names.insert("metal");
    for (const auto& name : names) {
      areas[name] += covered;
      rough_areas[name] += covered * material.roughness;
      if (material.texture) drawn_areas[name] += covered;
      if (material.transparent()) clear_areas[name] += covered;
    }
  }
  if (whole <= 0.0) return;
  looks.roughness = rough / whole;
  for (const auto& [name, covered] : areas)
    if (covered >= least_surface * whole) looks.surfaces[name] = rough_areas[name] / covered;
  const auto names_of = [&](const std::map<std::string, double>& some) {
    std::set<std::string> names;
    for (const auto& [name, covered] : some)
      if (covered >= least_surface * whole) names.insert(name);
    return names;
  };
  looks.drawings = names_of(drawn_areas), looks.clear = names_of(clear_areas);
}

// The least angle from below the centre of the surface to the edge of what it stands on, the box around its feet.
double steadiness_of(const Mesh& mesh) {
  constexpr double feet = 0.02;  // metres
  const double floor = bounds(mesh).low.z();
  Bounds3 base;
  for (const auto& position : mesh.positions)
    if (position.z() <= floor + feet) base.add(position.cast<double>());
  Vec3 center = Vec3::Zero();
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    const auto corner = [&](std::size_t k) -> Vec3 { return mesh.positions[t[k]].cast<double>(); };
    const Vec3 a = corner(0), b = corner(1), c = corner(2);
    const double part = (b - a).cross(c - a).norm();
    center += part * (a + b + c) / 3.0, area += part;
  }
  if (area <= 0.0) return 0.0;
  center /= area;
  const Vec3 inside = (center - base.low).cwiseMin(base.high - center);
  return degrees(std::atan2(std::min(inside.x(), inside.y()), std::max(1e-6, center.z() - floor)));
}

}  // namespace

KnownLooks known_looks(const Object& object, const ModelTable& models) {
  KnownLooks looks;
  looks.identity = identify(object);
  if (const auto model = models.find(asset_key(object.asset))) {
    looks.colors = shown_colors(*model);
    look_at_surfaces(*model, looks);
    const Mesh mesh = merged_mesh(*model);
    looks.outline = outline_of(mesh);
    looks.steadiness = steadiness_of(mesh);
    looks.making = model->making;
  }
  const SeenAsset* seen = seen_asset(object.asset);
  if (seen && !looks.making.known()) looks.making = seen->has;
  looks.size = object.size;
  const Kind* category = KindTable::built_in().find(looks.identity.kind);
  looks.usual = category ? category->size : object.size;
  looks.is_kind_known = category != nullptr;
  looks.mount = object.mount;
  return looks;
}

}  // namespace roomgen
