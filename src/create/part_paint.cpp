#include "part_paint.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "roomgen/base/text.h"
#include "scene/finish.h"

namespace roomgen::create {

namespace {

constexpr float second_half = 0.68f;  // of a tone: what a pattern's second tone is unless named

int longest_axis(const Mesh& mesh) {
  int axis = 0;
  bounds(mesh).size().maxCoeff(&axis);
  return axis;
}

// Each face by the two axes along it, `along` first: the grain of wood runs that way.
void map_in_metres(Mesh& mesh, double extent) {
  const int along = longest_axis(mesh);
  Mesh mapped;
  std::map<std::pair<std::uint32_t, int>, std::uint32_t> known;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3f normal = (mesh.positions[triangle[1]] - mesh.positions[triangle[0]])
                                       .cross(mesh.positions[triangle[2]] - mesh.positions[triangle[0]]);
    int across = 0;
    normal.cwiseAbs().maxCoeff(&across);
    const int u = across != along ? along : (across + 1) % 3, v = 3 - across - u;
    Triangle corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t old = triangle[k];
      const auto [entry, is_new] = known.try_emplace({old, across}, static_cast<std::uint32_t>(mapped.positions.size()));
      corners[k] = entry->second;
      if (!is_new) continue;
      const Eigen::Vector3f& at = mesh.positions[old];
      mapped.positions.push_back(at);
      if (!mesh.normals.empty()) mapped.normals.push_back(mesh.normals[old]);
      mapped.uvs.emplace_back(at[u] / static_cast<float>(extent), -at[v] / static_cast<float>(extent));
    }
    mapped.triangles.push_back(corners);
  }
  mesh = std::move(mapped);
}

void cover(ModelPart& part, Material& material, const PaintBox::Drawing& drawing) {
  map_in_metres(part.mesh, drawing.extent);
  material.texture = drawing.image;
  material.base_color = material_color(Tone::Constant(255), material.base_color[3]);
}

Tone second_tone(const PartLook& look, const Tone& first) {
  if (look.tones.size() > 1) return look.tones[1];
  if (look.pattern && look.pattern->paint != "marble" && look.pattern->paint != "speckle") return look.pattern->second;
  return second_half * first;
}

void take_substance(Material& material, const shape::Surface& substance) {
  material.roughness = static_cast<float>(substance.roughness);
  material.metallic = static_cast<float>(substance.metalness);
  material.base_color[3] = static_cast<float>(substance.opacity);
}

}  // namespace

Tone mean_tone(const Material& material) {
  Tone tone(srgb255_from_linear(material.base_color[0]), srgb255_from_linear(material.base_color[1]),
            srgb255_from_linear(material.base_color[2]));
  if (material.texture) tone = tone.cwiseProduct(mean_of(*material.texture)) / 255.0f;
  return tone;
}

void paint_part(ModelPart& part, Material& material, const PartLook& look, bool is_same_stuff,
                PaintBox& paints) {
  const Tone tone = look.tone().value_or(in_shades(mean_tone(material), look.shades));
  const bool has_drawing = material.texture && !part.mesh.uvs.empty();
  const bool keeps_drawing = has_drawing && (is_same_stuff || !look.substance);
  if (look.substance) take_substance(material, *look.substance);
  if (look.gloss) material.roughness = static_cast<float>(*look.gloss);
  if (look.pattern) {
    cover(part, material, paints.drawing(look.pattern->paint, look.pattern->scale, tone, second_tone(look, tone)));
  } else if (keeps_drawing) {
    material.texture = paints.toned(material.texture, tone);
    material.base_color = material_color(Tone::Constant(255), material.base_color[3]);
  } else if (look.substance && look.substance->pattern != "none") {
    cover(part, material, paints.drawing(look.substance->pattern, look.substance->scale, tone, second_tone(look, tone)));
  } else {
    material.texture = nullptr;
    material.base_color = material_color(tone, material.base_color[3]);
  }
  material.name = join(look.said, " ");
}

}  // namespace roomgen::create
