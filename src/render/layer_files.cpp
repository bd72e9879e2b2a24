#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "gray_png.h"
#include "roomgen/base/json.h"
#include "roomgen/render/pictures.h"
#include "view/category_colors.h"

namespace roomgen {

namespace {

using Colors = std::map<std::string, Rgb>;

constexpr double most_millimetres = 65535.0;

Colors colors_in(const Layers& layers) {
  std::set<std::string> categories;
  for (const auto& thing : layers.things) categories.insert(thing.category);
  return category_colors(categories);
}

std::vector<std::uint16_t> millimetres(const std::vector<float>& metres) {
  std::vector<std::uint16_t> result;
  for (const float depth : metres) {
    const double value = std::isfinite(depth) ? std::clamp(1000.0 * depth, 1.0, most_millimetres) : 0.0;
    result.push_back(static_cast<std::uint16_t>(std::lround(value)));
  }
  return result;
}

template <typename ColorOf>
Image picture_of_pixels(const Layers& layers, const ColorOf& color_of) {
  Image image(layers.camera.width, layers.camera.height);
  for (std::size_t i = 0; i < layers.objects.size(); ++i) {
    const Rgb color = color_of(i);
    std::copy(color.begin(), color.end(), &image.pixels[4 * i]);
    image.pixels[4 * i + 3] = 255;
  }
  return image;
}

Image normal_picture(const Layers& layers) {
  return picture_of_pixels(layers, [&](std::size_t i) {
    Rgb color{};
    for (int axis = 0; axis < 3; ++axis)
      color[static_cast<std::size_t>(axis)] =
          static_cast<std::uint8_t>(std::lround(127.5f + 127.0f * layers.normals[i][axis]));
    return color;
  });
}

Image segment_picture(const Layers& layers, const Colors& colors) {
  return picture_of_pixels(layers, [&](std::size_t i) {
    const auto number = layers.objects[i];
    return number == 0 ? Rgb{} : colors.at(layers.things[number - 1u].category);
  });
}

Json matrix_json(const Eigen::Matrix4d& m) {
  Json rows = Json::array();
  for (int row = 0; row < 4; ++row) {
    Json values = Json::array();
    for (int column = 0; column < 4; ++column) values.push_back(rounded(m(row, column), 9));
    rows.push_back(values);
  }
  return rows;
}

// To axes as OpenCV has them: x to the right, y down, z away from the viewer.
Eigen::Matrix4d world_from_camera(const Camera& camera) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() << camera.right, -camera.up, -camera.backward;
  m.topRightCorner<3, 1>() = camera.origin();
  return m;
}

Json camera_json(const Camera& camera) {
  const double scale = camera.pixels_per_metre;
  // With parallel rays the origin is before the picture's middle already.
  const Vec2 shift = camera.eye ? Vec2(scale * camera.center) : Vec2(Vec2::Zero());
  const Eigen::Matrix4d pose = world_from_camera(camera);
  return {{"model", camera.eye ? "pinhole" : "orthographic"},
          {"width", camera.width},
          {"height", camera.height},
          {camera.eye ? "focal_length_px" : "pixels_per_metre", {rounded(scale, 6), rounded(scale, 6)}},
          {"principal_point_px",
           {rounded(0.5 * camera.width - shift.x(), 6), rounded(0.5 * camera.height + shift.y(), 6)}},
          {"axes", "x right, y down, z forward"},
          {"world_from_camera", matrix_json(pose)},
          {"camera_from_world", matrix_json(pose.inverse())}};
}

Json categories_json(const Layers& layers, const Colors& colors) {
  std::map<int, std::string> by_number;
  for (const auto& thing : layers.things) by_number[thing.category_id] = thing.category;
  Json list = Json::array();
  for (const auto& [number, category] : by_number) {
    const Rgb& color = colors.at(category);
    list.push_back({{"value", number}, {"category", category}, {"color", {color[0], color[1], color[2]}}});
  }
  return list;
}

Json things_json(const Layers& layers) {
  const bool counted = std::any_of(layers.things.begin(), layers.things.end(),
                                   [](const LayerThing& thing) { return thing.pixels_alone > 0; });
  Json list = Json::array();
  for (std::size_t k = 0; k < layers.things.size(); ++k) {
    const LayerThing& thing = layers.things[k];
    Json one = {{"value", k + 1}, {"id", thing.id}, {"category", thing.category}, {"pixels", thing.pixels}};
    if (counted) one["pixels_alone"] = thing.pixels_alone;
    list.push_back(one);
  }
  return list;
}

std::string_view view_name(View::Kind kind) {
  switch (kind) {
    case View::Kind::top: return "top";
    case View::Kind::isometric: return "iso";
    case View::Kind::eye: return "eye";
  }
  return "";
}

}  // namespace

Status write_layers(const OutputFolder& folder, const std::string& name, const Layers& layers) {
  const Colors colors = colors_in(layers);
  const int width = layers.camera.width, height = layers.camera.height;
  Json files;
  Status status;
  const auto add = [&](const std::string& layer, const Result<std::string>& bytes) {
    if (!status) return;
    const std::string file = name + (layer == "color" ? "" : "." + layer) + ".png";
    files[layer] = file;
    status = bytes ? folder.write(file, *bytes) : Status(bytes.error());
  };
  if (!layers.color.empty()) add("color", encode_png(layers.color));
  add("depth", detail::encode_gray_png(millimetres(layers.depths), width, height));
  add("normals", encode_png(normal_picture(layers)));
  add("instances", detail::encode_gray_png(layers.objects, width, height));
  add("categories", detail::encode_gray_png(layers.categories, width, height));
  add("segments", encode_png(segment_picture(layers, colors)));
  if (!status) return status;
  const Json json = {{"format", "roomgen-layers"}, {"version", 1}, {"view", view_name(layers.kind)},
                     {"files", files}, {"camera", camera_json(layers.camera)},
                     {"categories", categories_json(layers, colors)}, {"things", things_json(layers)}};
  return folder.write(name + ".json", dump_json(json));
}

}  // namespace roomgen
