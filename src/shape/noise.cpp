#include "noise.h"

#include <algorithm>
#include <cmath>

#include "roomgen/base/random.h"

namespace roomgen::shape {

Noise::Noise(int columns, int rows, std::uint64_t seed) : columns_(columns), rows_(rows) {
  Random random(seed);
  for (int i = 0; i < columns * rows; ++i) values_.push_back(random.uniform());
}

double Noise::operator()(double u, double v) const {
  const double x = (u - std::floor(u)) * columns_, y = (v - std::floor(v)) * rows_;
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const double fx = smooth_step(0.0, 1.0, x - x0), fy = smooth_step(0.0, 1.0, y - y0);
  const auto value = [&](int column, int row) {
    return values_[static_cast<std::size_t>(row % rows_ * columns_ + column % columns_)];
  };
  const double low = value(x0, y0) + fx * (value(x0 + 1, y0) - value(x0, y0));
  const double high = value(x0, y0 + 1) + fx * (value(x0 + 1, y0 + 1) - value(x0, y0 + 1));
  return low + fy * (high - low);
}

Clouds::Clouds(int columns, int rows, std::uint64_t seed)
    : broad_(columns, rows, seed),
      middle_(2 * columns + 1, 2 * rows + 1, seed + 1),
      fine_(4 * columns + 1, 4 * rows + 1, seed + 2) {}

double Clouds::operator()(double u, double v) const {
  return (4.0 * broad_(u, v) + 2.0 * middle_(u, v) + fine_(u, v)) / 7.0;
}

double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

Image painted(int width, int height, const std::function<Rgb(double u, double v)>& color) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Rgb rgb = color((x + 0.5) / width, (y + 0.5) / height);
      std::uint8_t* pixel = image.at(x, y);
      for (int k = 0; k < 3; ++k)
        pixel[k] = static_cast<std::uint8_t>(std::lround(std::clamp(rgb[k], 0.0, 255.0)));
      pixel[3] = 255;
    }
  return image;
}

}  // namespace roomgen::shape
