#include "roomgen/geometry/model.h"

#include <algorithm>
#include <cmath>

namespace roomgen {

Bounds3 bounds(const Model& model) {
  Bounds3 result;
  for (const auto& part : model.parts)
    for (const auto& position : part.mesh.positions) result.add(position.cast<double>());
  return result;
}

std::size_t triangle_count(const Model& model) {
  std::size_t count = 0;
  for (const auto& part : model.parts) count += part.mesh.triangles.size();
  return count;
}

Mesh merged_mesh(const Model& model) {
  Mesh result;
  for (const auto& part : model.parts) {
    const auto first = static_cast<std::uint32_t>(result.positions.size());
    result.positions.insert(result.positions.end(), part.mesh.positions.begin(),
                            part.mesh.positions.end());
    for (const auto& t : part.mesh.triangles)
      result.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return result;
}

float linear_from_srgb(float srgb255) {
  const float s = std::clamp(srgb255 / 255.0f, 0.0f, 1.0f);
  return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
}

float srgb255_from_linear(float linear) {
  const float l = std::clamp(linear, 0.0f, 1.0f);
  return 255.0f * (l <= 0.0031308f ? 12.92f * l : 1.055f * std::pow(l, 1.0f / 2.4f) - 0.055f);
}

}  // namespace roomgen
