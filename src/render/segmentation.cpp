#include <algorithm>
#include <cmath>

#include "overlay.h"
#include "picture.h"
#include "roomgen/render/pictures.h"
#include "segmentation_legend.h"

namespace roomgen {

namespace {

using namespace detail;

constexpr Rgb paper{255, 255, 255}, edge_color{24, 26, 32};

View plan_view(int pixels) {
  View view;
  view.kind = View::Kind::top;
  view.marks = true;  // leaves room for labels around the walls
  view.pixels = pixels;
  return view;
}

// The plan as large as the legend lets it be.
Result<Camera> plan_camera(const Scene& scene, int pixels) {
  auto camera = make_camera(scene, plan_view(pixels));
  if (!camera) return camera;
  const double most = pixels - legend_width(pixels);
  if (camera->width <= most) return camera;
  return make_camera(scene, plan_view(static_cast<int>(most)));
}

std::map<std::string, Rgb> colors_of(const Layers& layers) {
  std::set<std::string> categories;
  for (const auto& thing : layers.things) categories.insert(thing.category);
  return category_colors(categories);
}

Image painted(const Layers& layers, const std::map<std::string, Rgb>& colors) {
  Image image(layers.camera.width, layers.camera.height);
  for (std::size_t i = 0; i < layers.objects.size(); ++i) {
    const auto number = layers.objects[i];
    const Rgb& color = number == 0 ? paper : colors.at(layers.things[number - 1u].category);
    std::copy(color.begin(), color.end(), &image.pixels[4 * i]);
    image.pixels[4 * i + 3] = 255;
  }
  return image;
}

// Walls are cut below the heads of doors and windows: what is left of these is little, so the holes are filled.
void paint_opening(Image& image, const Camera& camera, const Room& room, const Opening& opening, const Rgb& color) {
  const Segment line = segment(room, opening);
  const Vec2 outward = -inward(room, opening);
  const Footprint hole(line.middle() + 0.5 * wall_thickness * outward, {opening.width(), wall_thickness},
                       std::atan2(line.direction().y(), line.direction().x()));
  Bounds3 box;
  for (const auto& corner : hole.outline()) box.add({corner.x(), corner.y(), 0.0});
  const PixelRect touched = covered_pixels(camera, box).clipped({0, 0, image.width, image.height});
  for (int y = touched.y0; y < touched.y1; ++y)
    for (int x = touched.x0; x < touched.x1; ++x) {
      const Vec2 pixel(x + 0.5 - 0.5 * camera.width, 0.5 * camera.height - y - 0.5);
      const Vec2 local = hole.to_local(pixel / camera.pixels_per_metre + camera.center).cwiseAbs() - hole.half();
      if (local.maxCoeff() <= 0.0) std::copy(color.begin(), color.end(), image.at(x, y));
    }
}

// Between things, so that two chairs side by side are two.
void draw_edges(Image& image, const Layers& layers, std::size_t object_count) {
  const int width = layers.camera.width, height = layers.camera.height;
  const auto number = [&](int x, int y) { return layers.objects[static_cast<std::size_t>(y) * width + x]; };
  const auto is_object = [&](std::uint16_t n) { return n > 0 && n <= object_count; };
  for (int y = 0; y + 1 < height; ++y)
    for (int x = 0; x + 1 < width; ++x) {
      const auto here = number(x, y);
      for (const auto there : {number(x + 1, y), number(x, y + 1)})
        if (here != there && (is_object(here) || is_object(there)))
          std::copy(edge_color.begin(), edge_color.end(), image.at(x, y));
    }
}

// Objects that show, by name, then what the room is made of.
Legend legend_of(const Layers& layers, const std::map<std::string, Rgb>& colors, std::size_t object_count) {
  std::map<std::string, int> objects, parts;
  for (std::size_t k = 0; k < layers.things.size(); ++k) {
    const LayerThing& thing = layers.things[k];
    if (k < object_count && thing.pixels > 0) ++objects[thing.category];
    // Not counted: a door between two rooms is a thing of both.
    if (k >= object_count && thing.category != "ceiling") parts[thing.category] = 1;
  }
  Legend legend{{}, colors, layers.camera.pixels_per_metre};
  for (const auto* group : {&objects, &parts})
    for (const auto& [category, count] : *group) legend.entries.push_back({category, count});
  return legend;
}

}  // namespace

Result<Image> segmentation_picture(Renderer& renderer, const Scene& scene, const ModelTable& models, int pixels) {
  const auto camera = plan_camera(scene, pixels);
  if (!camera) return camera.error();
  Shot shot;
  shot.camera = *camera;
  shot.kind = View::Kind::top;
  shot.color = false;
  const auto layers = renderer.layers(scene, models, shot);
  if (!layers) return layers.error();

  const auto colors = colors_of(*layers);
  Image image = painted(*layers, colors);
  for (const auto& room : rooms_of(scene))
    for (const auto& opening : room.openings)
      paint_opening(image, *camera, room, opening, colors.at(std::string(name(opening.type))));
  draw_edges(image, *layers, scene.objects.size());
  for (const auto& drawing : {plan_symbols(rooms_of(scene), *camera), layout_segment_labels(scene, *camera)})
    if (auto drawn = draw_overlay(image, drawing); !drawn) return drawn.error();
  return with_legend(image, legend_of(*layers, colors, scene.objects.size()), legend_width(pixels));
}

}  // namespace roomgen
