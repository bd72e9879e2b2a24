#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "roomgen/geometry/vec.h"

namespace roomgen {

/// 8-bit RGBA pixels, sRGB, rows from the top, no padding.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;  ///< 4 * width * height bytes

  Image() = default;
  Image(int w, int h) : width(w), height(h), pixels(4 * static_cast<std::size_t>(w) * h) {}

  bool empty() const { return pixels.empty(); }
  std::uint8_t* at(int x, int y) { return pixels.data() + 4 * (static_cast<std::size_t>(y) * width + x); }
  const std::uint8_t* at(int x, int y) const {
    return pixels.data() + 4 * (static_cast<std::size_t>(y) * width + x);
  }
};

inline bool is_opaque(const Image& image) {
  for (std::size_t i = 3; i < image.pixels.size(); i += 4)
    if (image.pixels[i] != 255) return false;
  return true;
}

using Triangle = std::array<std::uint32_t, 3>;

/// An edge between two vertices as one number; the direction counts.
inline std::uint64_t directed_edge(std::uint32_t from, std::uint32_t to) {
  return std::uint64_t{from} << 32 | to;
}

/// Triangles over shared vertices, counter-clockwise seen from outside. `normals` and `uvs` are empty
/// or as long as `positions`; uv (0, 0) is the top left corner of the image, as in glTF.
struct Mesh {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Eigen::Vector2f> uvs;
  std::vector<Triangle> triangles;
};

struct Bounds3 {
  Vec3 low = Vec3::Constant(1e300);
  Vec3 high = Vec3::Constant(-1e300);

  bool empty() const { return low.x() > high.x(); }
  void add(const Vec3& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  Vec3 size() const { return high - low; }
  Vec3 center() const { return 0.5 * (low + high); }
};

Bounds3 bounds(const Mesh& mesh);

/// Drops triangles that repeat an index, have an index out of range, a vertex that is not finite, or
/// an area below `min_area` square metres, then drops vertices that nothing uses. Returns how many
/// triangles went.
std::size_t remove_degenerate(Mesh& mesh, double min_area = 1e-12);

/// Fills `normals` where they are missing, of zero length or not finite, with the area-weighted mean
/// of the faces that meet within `crease` radians; vertices are split where a crease needs it.
void repair_normals(Mesh& mesh, double crease = 0.7);

/// Appends `other`, each position p mapped to scale * p + offset (component by component).
void append(Mesh& mesh, const Mesh& other, const Vec3& scale = Vec3::Ones(),
            const Vec3& offset = Vec3::Zero());

/// An axis-aligned box with flat normals and uvs in metres, 24 vertices.
Mesh make_box(const Vec3& low, const Vec3& high);

/// Physically based surface after glTF 2.0's metallic-roughness model. Colours are linear RGBA.
struct Material {
  std::string name;
  std::array<float, 4> base_color = {0.8f, 0.8f, 0.8f, 1.0f};
  std::shared_ptr<const Image> texture;  ///< multiplies base_color; may be null
  float roughness = 0.8f;
  float metallic = 0.0f;
  float glow = 0.0f;  ///< how much of its colour it shows without any light
  bool double_sided = false;

  bool transparent() const { return base_color[3] < 0.999f; }
};

/// Triangles of one material.
struct ModelPart {
  Mesh mesh;
  int material = 0;  ///< index into Model::materials
};

/// What is known of a thing by who made it from a recipe; of meshes from files nothing is.
struct Making {
  std::map<std::string, int> parts;         ///< how many there are of each: "drawer"
  std::map<std::string, std::string> ways;  ///< what was chosen where there was a choice: "leg_style": "pedestal"

  bool known() const { return !parts.empty(); }
};

/// A thing to be placed. Frame: origin at the bottom centre of its box, width along X, depth along Y,
/// height along Z, front towards -Y, metres.
struct Model {
  std::vector<ModelPart> parts;
  std::vector<Material> materials;
  Making making;
};

Bounds3 bounds(const Model& model);
std::size_t triangle_count(const Model& model);
/// All parts as one mesh without normals and uvs: what collision works on.
Mesh merged_mesh(const Model& model);
/// A colour of the sRGB standard (IEC 61966-2-1), 0 to 255, as linear light, and back.
float linear_from_srgb(float srgb255);
float srgb255_from_linear(float linear);

}  // namespace roomgen
