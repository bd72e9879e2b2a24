#include "surfaces.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "drawing.h"
#include "motifs.h"
#include "picture.h"
#include "roomgen/base/json.h"

namespace roomgen::shape::detail {

namespace {

constexpr double motif_extent = 0.4;  // metres

std::array<float, 4> linear(const Rgb& color, double opacity) {
  return {linear_from_srgb(color[0]), linear_from_srgb(color[1]), linear_from_srgb(color[2]),
          static_cast<float>(opacity)};
}

Eigen::Vector3f floats(const Rgb& color) {
  return {static_cast<float>(color[0]), static_cast<float>(color[1]), static_cast<float>(color[2])};
}

Theme theme_of(const std::string& name) {
  const auto names = picture_themes();
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? Theme::plain : static_cast<Theme>(found - names.begin());
}

Rgb darker(const Rgb& color) {
  Rgb result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = static_cast<std::uint8_t>(color[k] * 0.68);
  return result;
}

double aspect_of(const PicturePart& picture) {
  return std::clamp(picture.size.x() / picture.size.y(), 0.2, 5.0);
}

// A motif in the middle, and smaller at the corners, on the colour: it tiles seamlessly.
PicturePart printed(const Motif& motif, const Rgb& ground) {
  char color[8];
  std::snprintf(color, sizeof color, "#%02x%02x%02x", ground[0], ground[1], ground[2]);
  const Json figure = figure_of(motif);
  Json shapes = Json::array();
  const auto print = [&](double x, double y, double size) {
    shapes.push_back(
        {{"group", figure}, {"at", {x - 0.5 * size, y - 0.5 * size}}, {"scale", size}});
  };
  print(0.5, 0.5, 0.6);
  for (const int corner : {0, 1, 2, 3}) print(corner % 2, corner / 2, 0.4);
  PicturePart tile;
  tile.drawing = json_line({{"ground", color}, {"shapes", shapes}});
  return tile;
}

Painted plain(const Surface& surface) {
  Painted result;
  result.material.name = surface.name;
  result.material.roughness = static_cast<float>(surface.roughness);
  result.material.metallic = static_cast<float>(surface.metalness);
  result.material.glow = static_cast<float>(surface.glow);
  result.first = parse_color(surface.color).value_or(Rgb{204, 204, 204});
  result.material.base_color = linear(result.first, surface.opacity);
  result.pattern = pattern_named(surface.pattern);
  if (const Motif* motif = find_motif(surface.pattern)) {
    result.picture = printed(*motif, result.first);
    result.extent = motif_extent * surface.scale;
  }
  if (result.pattern == Pattern::none) return result;
  result.second = parse_color(surface.second).value_or(darker(result.first));
  result.extent = pattern_extent(result.pattern) * surface.scale;
  return result;
}

}  // namespace

Surfaces::Surfaces(const Program& program) {
  for (const auto& surface : program.materials)
    names_.emplace_back(surface.name, add(plain(surface)));
}

std::shared_ptr<const Image> Surfaces::texture(const Painted& painted) {
  if (painted.picture && !painted.picture->drawing.empty())
    return std::make_shared<Image>(paint_drawing(painted.picture->drawing, painted.picture->seed,
                                                 aspect_of(*painted.picture)));
  if (painted.picture)
    return std::make_shared<Image>(paint_picture(
        theme_of(painted.picture->theme), painted.picture->seed, aspect_of(*painted.picture)));
  auto& image = patterns_[{painted.pattern, painted.first, painted.second}];
  if (!image)
    image = std::make_shared<Image>(
        paint_pattern(painted.pattern, floats(painted.first), floats(painted.second), 0));
  return image;
}

std::vector<Material> Surfaces::paint(const std::vector<bool>& used) {
  std::vector<Material> materials;
  for (std::size_t k = 0; k < painted_.size(); ++k) {
    Painted& painted = painted_[k];
    if (used[k] && (painted.picture || painted.pattern != Pattern::none)) {
      painted.material.texture = texture(painted);
      // The image carries all colours, so the base colour is white.
      std::fill_n(painted.material.base_color.begin(), 3, 1.0f);
    }
    materials.push_back(painted.material);
  }
  return materials;
}

int Surfaces::add(Painted painted) {
  painted_.push_back(std::move(painted));
  return static_cast<int>(painted_.size()) - 1;
}

int Surfaces::find(const std::string& name) {
  for (const auto& [known, index] : names_)
    if (known == name) return index;
  Surface grey;
  grey.name = name;
  names_.emplace_back(name, add(plain(grey)));
  return names_.back().second;
}

int Surfaces::picture(const PicturePart& picture, int frame) {
  const auto key = std::make_tuple(picture.theme + picture.drawing, picture.seed, aspect_of(picture), frame);
  if (const auto known = pictures_.find(key); known != pictures_.end()) return known->second;
  Painted result;
  result.material = painted_[static_cast<std::size_t>(frame)].material;
  result.material.name = picture.drawing.empty() ? picture.theme : "drawing";
  result.material.base_color[3] = 1.0f;
  result.picture = picture;
  if (theme_of(picture.theme) == Theme::mirror) {
    result.material.roughness = 0.05f;
    result.material.metallic = 0.9f;
  }
  return pictures_[key] = add(std::move(result));
}

}  // namespace roomgen::shape::detail
