#include "roomgen/library/shown_colors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>

namespace roomgen {

namespace {

constexpr double least_share = 0.2;

// Mean of the visible pixels, sRGB.
std::array<float, 3> mean_color(const Image& image) {
  std::array<double, 3> sum{};
  double weight = 1e-9;
  for (std::size_t i = 0; i + 3 < image.pixels.size(); i += 4) {
    const double alpha = image.pixels[i + 3] / 255.0;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += alpha * image.pixels[i + c];
    weight += alpha;
  }
  std::array<float, 3> mean{};
  for (std::size_t c = 0; c < 3; ++c) mean[c] = static_cast<float>(sum[c] / weight);
  return mean;
}

std::array<float, 3> shown_color(const Material& material) {
  std::array<float, 3> color{255, 255, 255};
  if (material.texture) color = mean_color(*material.texture);
  for (std::size_t c = 0; c < 3; ++c)
    color[c] *= srgb255_from_linear(material.base_color[c]) / 255.0f;
  return color;
}

// Names of strong colours by hue in degrees; 15 to 50 degrees is the realm of wood and leather.
std::string hue_name(float hue, float saturation, float value) {
  if (hue >= 12 && hue < 52) {
    if (value < 0.72f || (hue < 40 && saturation >= 0.48f && value < 0.85f)) return "brown";
    if (saturation < 0.48f) return "beige";
    return hue < 40 ? (saturation > 0.7f ? "orange" : "brown") : "yellow";
  }
  if (hue >= 52 && hue < 70) return "yellow";
  if (hue >= 70 && hue < 165) return "green";
  if (hue >= 165 && hue < 258) return "blue";
  if (hue >= 258 && hue < 300) return "purple";
  return hue >= 300 && value > 0.6f && (hue < 345 || saturation < 0.5f) ? "pink" : "red";
}

}  // namespace

double surface_area(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles)
    sum += 0.5 * (mesh.positions[t[1]] - mesh.positions[t[0]])
                     .cross(mesh.positions[t[2]] - mesh.positions[t[0]])
                     .norm();
  return sum;
}

std::string color_name(float red, float green, float blue) {
  const float high = std::max({red, green, blue}), low = std::min({red, green, blue});
  const float value = high / 255.0f, spread = high - low;
  const float saturation = high > 0.0f ? spread / high : 0.0f;
  if (value < 0.18f) return "black";
  if (saturation < 0.13f) return value > 0.74f ? "white" : value < 0.27f ? "black" : "grey";
  float hue = 0.0f;
  if (high == red)
    hue = 60.0f * (green - blue) / spread;
  else if (high == green)
    hue = 120.0f + 60.0f * (blue - red) / spread;
  else
    hue = 240.0f + 60.0f * (red - green) / spread;
  if (hue < 0.0f) hue += 360.0f;
  return hue_name(hue, saturation, value);
}

std::vector<ShownColor> shown_colors(const Model& model) {
  std::map<std::string, ShownColor> by_name;
  double whole = 0.0;
  for (const auto& part : model.parts) {
    const auto color = shown_color(model.materials[static_cast<std::size_t>(part.material)]);
    const double covered = surface_area(part.mesh);
    ShownColor& sum = by_name[color_name(color[0], color[1], color[2])];
    sum.share += covered;
    for (std::size_t c = 0; c < 3; ++c) sum.mean[c] += static_cast<float>(covered) * color[c];
    whole += covered;
  }
  std::vector<ShownColor> colors;
  for (auto& [name, sum] : by_name) {
    if (sum.share <= 0.0) continue;
    sum.name = name;
    for (auto& component : sum.mean) component /= static_cast<float>(sum.share);
    sum.share /= whole;
    colors.push_back(std::move(sum));
  }
  std::stable_sort(colors.begin(), colors.end(),
                   [](const auto& a, const auto& b) { return a.share > b.share; });
  return colors;
}

double lightness(const std::array<float, 3>& srgb) {
  return (0.299 * srgb[0] + 0.587 * srgb[1] + 0.114 * srgb[2]) / 255.0;
}

std::vector<std::string> main_colors(const Model& model) {
  std::vector<std::string> names;
  for (const auto& color : shown_colors(model))
    if (color.share >= least_share) names.push_back(color.name);
  return names;
}

}  // namespace roomgen
