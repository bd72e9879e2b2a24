#include "glb_lights.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "geometry/conventions.h"

namespace roomgen::detail {

namespace {

constexpr const char* extension = "KHR_lights_punctual";
// The edge of a lamp's cone is soft over this part of it.
constexpr double soft_edge = 0.3;

Vec3 to_gltf(const Vec3& v) {
  return find_axis_convention("gltf")->theirs_from_ours * v;
}

Json color_json(const Eigen::Vector3f& color) {
  return {rounded(color.x(), 4), rounded(color.y(), 4), rounded(color.z(), 4)};
}

// Lights shine along -Z of their node.
Json rotation_towards(const Vec3& direction) {
  const auto q =
      Eigen::Quaterniond::FromTwoVectors(-Vec3::UnitZ(), to_gltf(direction)).normalized();
  return {rounded(q.x(), 9), rounded(q.y(), 9), rounded(q.z(), 9), rounded(q.w(), 9)};
}

}  // namespace

Json GlbLights::node_of(const std::string& name, Json light) {
  const auto [known, is_new] =
      light_by_text_.try_emplace(light.dump(), static_cast<int>(lights_.size()));
  if (is_new) lights_.push_back(std::move(light));
  return {{"name", name}, {"extensions", {{extension, {{"light", known->second}}}}}};
}

Json GlbLights::lamp_node(const LampLight& lamp) {
  const bool is_spot = lamp.cone > 0.0;
  Json light = {{"type", is_spot ? "spot" : "point"},
                {"color", color_json(lamp.color)},
                {"intensity", rounded(lamp.candela, 3)}};
  if (is_spot) {
    const double cone = std::min(lamp.cone, 0.5 * pi);
    light["spot"] = {{"innerConeAngle", rounded((1.0 - soft_edge) * cone, 5)},
                     {"outerConeAngle", rounded(cone - 1e-5, 5)}};
  }
  Json node = node_of(lamp.object + " light", std::move(light));
  const Vec3 p = to_gltf(lamp.position);
  node["translation"] = {rounded(p.x(), 6), rounded(p.y(), 6), rounded(p.z(), 6)};
  if (is_spot) node["rotation"] = rotation_towards(-Vec3::UnitZ());
  return node;
}

Json GlbLights::sun_node(const Sunlight& sun) {
  Json node = node_of("sun", {{"type", "directional"},
                              {"color", color_json(sun_color())},
                              {"intensity", rounded(sun.lux, 3)}});
  node["rotation"] = rotation_towards(-sun.to_sun);
  return node;
}

void GlbLights::finish(Json& gltf) {
  if (lights_.empty()) return;
  gltf["extensionsUsed"] = {extension};
  gltf["extensions"] = {{extension, {{"lights", std::move(lights_)}}}};
}

}  // namespace roomgen::detail
