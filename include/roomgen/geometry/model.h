#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "roomgen/geometry/image.h"
#include "roomgen/geometry/mesh.h"

namespace roomgen {

/// Physically based surface after glTF 2.0's metallic-roughness model. Colours are linear RGBA.
struct Material {
  std::string name;
  std::array<float, 4> base_color = {0.8f, 0.8f, 0.8f, 1.0f};
  std::shared_ptr<const Image> texture;  ///< multiplies base_color; may be null
  float roughness = 0.8f;
  float metallic = 0.0f;
  bool double_sided = false;

  bool transparent() const { return base_color[3] < 0.999f; }
};

/// Triangles of one material.
struct ModelPart {
  Mesh mesh;
  int material = 0;  ///< index into Model::materials
};

/// A thing to be placed. Frame: origin at the bottom centre of its box, width along X, depth along Y,
/// height along Z, front towards -Y, metres.
struct Model {
  std::vector<ModelPart> parts;
  std::vector<Material> materials;
};

Bounds3 bounds(const Model& model);
std::size_t triangle_count(const Model& model);
/// All parts as one mesh without normals and uvs: what collision works on.
Mesh merged_mesh(const Model& model);
/// A colour of the sRGB standard (IEC 61966-2-1), 0 to 255, as linear light, and back.
float linear_from_srgb(float srgb255);
float srgb255_from_linear(float linear);

}  // namespace roomgen
