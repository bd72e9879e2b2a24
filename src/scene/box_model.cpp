#include "box_model.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "finish.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::array<std::array<float, 3>, 12> palette = {{{{132, 164, 176}},
                                                           {{196, 150, 116}},
                                                           {{150, 172, 136}},
                                                           {{204, 178, 124}},
                                                           {{178, 138, 142}},
                                                           {{146, 146, 178}},
                                                           {{188, 166, 148}},
                                                           {{120, 156, 148}},
                                                           {{206, 160, 138}},
                                                           {{160, 160, 156}},
                                                           {{172, 150, 176}},
                                                           {{142, 134, 116}}}};

void add_part(Model& model, Mesh mesh, const Eigen::Vector3f& color) {
  Material material;
  material.name = "box";
  material.base_color = material_color(color);
  material.roughness = 0.7f;
  model.parts.push_back({std::move(mesh), static_cast<int>(model.materials.size())});
  model.materials.push_back(material);
}

Mesh cylinder(const Vec3& size) {
  constexpr std::uint32_t sides = 48;
  Mesh mesh;
  const auto rim = [&](std::uint32_t i) {
    const double angle = 2.0 * pi * i / sides;
    return Vec2(std::cos(angle), std::sin(angle));
  };
  const auto vertex = [&](const Vec2& at, double z, const Vec3& normal) {
    mesh.positions.push_back(
        Vec3(0.5 * size.x() * at.x(), 0.5 * size.y() * at.y(), z).cast<float>());
    mesh.normals.push_back(normal.normalized().cast<float>());
  };
  for (std::uint32_t i = 0; i < sides; ++i) {
    const Vec3 out(rim(i).x() / size.x(), rim(i).y() / size.y(), 0.0);
    vertex(rim(i), 0.0, out);
    vertex(rim(i), size.z(), out);
    vertex(rim(i), 0.0, -Vec3::UnitZ());
    vertex(rim(i), size.z(), Vec3::UnitZ());
  }
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t a = 4 * i, b = 4 * ((i + 1) % sides);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
    if (i == 0 || i == sides - 1) continue;
    mesh.triangles.push_back({2, b + 2, a + 2});
    mesh.triangles.push_back({3, a + 3, b + 3});
  }
  return mesh;
}

}  // namespace

Eigen::Vector3f category_color(std::string_view category) {
  std::uint32_t hash = 2166136261u;  // FNV-1a
  for (const char c : category) hash = (hash ^ static_cast<std::uint8_t>(c)) * 16777619u;
  const auto& color = palette[(hash >> 8) % palette.size()];
  return {color[0], color[1], color[2]};
}

Model box_model(const Object& object) {
  const Eigen::Vector3f color = category_color(object.category);
  const Vec3 half(0.5 * object.size.x(), 0.5 * object.size.y(), 0.0);
  const Vec3 low = -half, high = half + Vec3(0, 0, object.size.z());
  Model model;
  if (object.traits.round) {
    add_part(model, cylinder(object.size), color);
    return model;
  }
  const double band = object.traits.front ? std::min(0.05, 0.12 * object.size.y()) : 0.0;
  const double split = low.y() + band;
  add_part(model, make_box({low.x(), split, low.z()}, high), color);
  if (band > 0) add_part(model, make_box(low, {high.x(), split, high.z()}), 0.72f * color);
  return model;
}

std::shared_ptr<const Model> model_or_box(const Object& object, const ModelTable& models) {
  if (auto model = models.find(asset_key(object.asset))) return model;
  return std::make_shared<Model>(box_model(object));
}

std::string model_key(const Object& object, const ModelTable& models) {
  const std::string key = asset_key(object.asset);
  if (models.find(key)) return key;
  const auto number = [](double value) { return format_number(value, 6); };
  return "box:" + object.category + ":" + number(object.size.x()) + "x" + number(object.size.y()) +
         "x" + number(object.size.z()) + (object.traits.round ? ":round" : "") +
         (object.traits.front ? ":front" : "");
}

}  // namespace roomgen
