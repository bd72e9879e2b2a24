#include "surfaces.h"

#include <algorithm>

#include "roomgen/shape/color.h"

namespace roomgen::shape::detail {

namespace {

std::array<float, 4> linear(const Rgb& color, double opacity) {
  return {linear_from_srgb(color[0]), linear_from_srgb(color[1]), linear_from_srgb(color[2]),
          static_cast<float>(opacity)};
}

Painted painted(const Surface& surface) {
  Painted result;
  result.material.name = surface.name;
  result.material.roughness = static_cast<float>(surface.roughness);
  result.material.metallic = static_cast<float>(surface.metalness);
  const Rgb color = parse_color(surface.color).value_or(Rgb{204, 204, 204});
  result.material.base_color = linear(color, surface.opacity);
  return result;
}

}  // namespace

Surfaces::Surfaces(const Program& program) {
  for (const auto& surface : program.materials)
    names_.emplace_back(surface.name, add(painted(surface)));
}

int Surfaces::add(Painted painted) {
  painted_.push_back(std::move(painted));
  return static_cast<int>(painted_.size()) - 1;
}

int Surfaces::find(const std::string& name) {
  for (const auto& [known, index] : names_)
    if (known == name) return index;
  Surface plain;
  plain.name = name;
  names_.emplace_back(name, add(painted(plain)));
  return names_.back().second;
}

int Surfaces::picture(const PicturePart& picture, int frame) {
  (void)picture;
  return frame;
}

}  // namespace roomgen::shape::detail
