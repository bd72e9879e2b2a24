#include "shown_colors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "visible_pixels.h"

namespace roomgen {

namespace {

constexpr double least_share = 0.2;

constexpr int swatch_side = 24;     // of a texture: stripes stay apart, grain does not
constexpr float see_through = 0.5f;  // less than this much of what is behind is hidden

// A texture in few pixels, each the mean of what it stands for: red, green, blue in sRGB and alpha, 0 to
// 255.
class Swatch {
 public:
  explicit Swatch(const Image& image)
      : width_(std::clamp(image.width, 1, swatch_side)), height_(std::clamp(image.height, 1, swatch_side)) {
    std::vector<std::array<double, 5>> sums(static_cast<std::size_t>(width_ * height_));
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        auto& sum = sums[index(x * width_ / image.width, y * height_ / image.height)];
        const std::uint8_t* pixel = image.at(x, y);
        const double alpha = pixel[3] / 255.0;
        for (std::size_t c = 0; c < 3; ++c) sum[c] += alpha * pixel[c];
        sum[3] += alpha;
        sum[4] += 1.0;
      }
    for (const auto& sum : sums) {
      std::array<float, 4> mean{};
      for (std::size_t c = 0; c < 3; ++c) mean[c] = static_cast<float>(sum[c] / std::max(sum[3], 1e-9));
      mean[3] = static_cast<float>(255.0 * sum[3] / std::max(sum[4], 1e-9));
      colors_.push_back(mean);
    }
  }

  const std::array<float, 4>& at(const Vec2& uv) const {
    const auto cell = [](double t, int count) {
      return std::clamp(static_cast<int>((t - std::floor(t)) * count), 0, count - 1);
    };
    return colors_[index(cell(uv.x(), width_), cell(uv.y(), height_))];
  }

 private:
  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row * width_ + column); }

  int width_, height_;
  std::vector<std::array<float, 4>> colors_;
};

class Paint {
 public:
  explicit Paint(const Model& model) : model_(model) {
    for (const auto& material : model.materials) {
      auto& factor = factors_.emplace_back();
      for (std::size_t c = 0; c < 3; ++c) factor[c] = srgb255_from_linear(material.base_color[c]) / 255.0f;
      factor[3] = material.base_color[3];
      if (material.texture && !material.texture->pixels.empty())
        swatches_.try_emplace(material.texture.get(), *material.texture);
    }
  }

  /// sRGB and alpha, 0 to 255.
  std::array<float, 4> at(const VisiblePixel& pixel) const {
    const auto index = static_cast<std::size_t>(model_.parts[pixel.part].material);
    std::array<float, 4> color{255, 255, 255, 255};
    const auto swatch = swatches_.find(model_.materials[index].texture.get());
    if (swatch != swatches_.end() && pixel.uv.allFinite()) color = swatch->second.at(pixel.uv);
    for (std::size_t c = 0; c < 4; ++c) color[c] *= factors_[index][c];
    return color;
  }

 private:
  const Model& model_;
  std::vector<std::array<float, 4>> factors_;  ///< by material
  std::map<const Image*, Swatch> swatches_;  // looked up, never gone through
};

// Names of strong colours by hue in degrees; 12 to 52 degrees is the realm of wood and leather, and so
// are dark reds.
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
  if (hue < 12 && value < 0.38f) return "brown";
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
  const Paint paint(model);
  const auto add = [&](const VisiblePixel& pixel) {
    const auto color = paint.at(pixel);
    ShownColor& sum = by_name[color_name(color[0], color[1], color[2])];
    sum.share += pixel.area;
    for (std::size_t c = 0; c < 3; ++c) sum.mean[c] += static_cast<float>(pixel.area) * color[c];
    whole += pixel.area;
  };
  const auto hides = [&](const VisiblePixel& pixel) { return paint.at(pixel)[3] >= 255.0f * see_through; };
  each_visible_pixel(model, hides, add);
  // Of what is all glass, the glass is seen.
  if (whole <= 0.0) each_visible_pixel(model, [](const auto&) { return true; }, add);
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
