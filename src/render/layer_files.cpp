#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "layer_pictures.h"
#include "roomgen/base/json.h"
#include "roomgen/render/pictures.h"
#include "view/camera_json.h"
#include "view/category_colors.h"

namespace roomgen {

namespace {

using Colors = std::map<std::string, Rgb>;

Colors colors_in(const Layers& layers) {
  std::set<std::string> categories;
  for (const auto& thing : layers.things) categories.insert(thing.category);
  return category_colors(categories);
}

Image segment_picture(const Layers& layers, const Colors& colors) {
  return detail::picture_of_pixels(layers, [&](std::size_t i) {
    const auto number = layers.objects[i];
    return number == 0 ? Rgb{} : colors.at(layers.things[number - 1u].category);
  });
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
    case View::Kind::elevation:
      return "elevation";
  }
  return "";
}

}  // namespace

Status write_layers(const OutputFolder& folder, const std::string& name, const Layers& layers) {
  const Colors colors = colors_in(layers);
  Json files;
  Status status;
  const auto add = [&](const std::string& layer, const Result<std::string>& bytes) {
    if (!status) return;
    const std::string file = name + (layer == "color" ? "" : "." + layer) + ".png";
    files[layer] = file;
    status = bytes ? folder.write(file, *bytes) : Status(bytes.error());
  };
  if (!layers.color.empty()) add("color", encode_png(layers.color));
  add("depth", detail::encode_depths(layers));
  add("normals", detail::encode_normals(layers));
  add("instances", detail::encode_instances(layers));
  add("categories", detail::encode_categories(layers));
  add("segments", encode_png(segment_picture(layers, colors)));
  if (!status) return status;
  const Json json = {{"format", "roomgen-layers"}, {"version", 1}, {"view", view_name(layers.kind)},
                     {"files", files}, {"camera", camera_json(layers.camera)},
                     {"categories", categories_json(layers, colors)}, {"things", things_json(layers)}};
  return folder.write(name + ".json", dump_json(json));
}

}  // namespace roomgen
