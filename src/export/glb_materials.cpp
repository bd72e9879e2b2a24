#include "glb_materials.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/sha256.h"
#include "roomgen/base/json.h"

namespace roomgen::detail {

namespace {

constexpr double mask_cutoff = 0.4;  // as the renderer's

double unit(float value) {
  return rounded(std::clamp(static_cast<double>(value), 0.0, 1.0), 5);
}

// Linear mean of the texels, by their alpha.
std::array<float, 4> mean_color(const Image& image) {
  std::array<double, 4> sum{};
  double weight = 0.0;
  for (std::size_t i = 0; i + 3 < image.pixels.size(); i += 4) {
    const double alpha = image.pixels[i + 3] / 255.0;
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += alpha * linear_from_srgb(static_cast<float>(image.pixels[i + c]));
    sum[3] += alpha;
    weight += 1.0;
  }
  std::array<float, 4> mean = {1, 1, 1, 1};
  if (weight == 0.0 || sum[3] == 0.0) return mean;
  for (std::size_t c = 0; c < 3; ++c) mean[c] = static_cast<float>(sum[c] / sum[3]);
  mean[3] = static_cast<float>(sum[3] / weight);
  return mean;
}

}  // namespace

Result<int> GlbMaterials::texture_of(const Image& image,
                                    const std::string& material) {
  auto encoded = encode_(image);
  if (!encoded) return with_context(encoded.error(), "texture");
  const auto [known, is_new] =
      texture_by_hash_.try_emplace(sha256_hex(encoded->bytes), static_cast<int>(images_.size()));
  if (is_new)
    images_.push_back({{"name", image_names_.take(material, "picture")},
                       {"mimeType", encoded->mime_type},
                       {"bufferView", buffer_.add_image(encoded->bytes)}});
  return known->second;
}

Result<GlbMaterials::Surface> GlbMaterials::surface_of(const Material& material) {
  const Image* image = material.texture.get();
  if (const auto known = surfaces_.find(image); known != surfaces_.end()) return known->second;
  Surface surface;
  Material opaque;
  opaque.texture = material.texture;
  surface.alpha = alpha_mode(opaque);
  if (encode_) {
    const auto texture = texture_of(*image, material.name);
    if (!texture) return texture.error();
    surface.texture = *texture;
  } else {
    surface.mean = mean_color(*image);
  }
  kept_.push_back(material.texture);
  surfaces_[image] = surface;
  return surface;
}

Json GlbMaterials::looks(const Material& material, const Surface& surface) {
  const AlphaMode alpha = material.transparent() ? AlphaMode::blend : surface.alpha;
  Json color = Json::array();
  for (std::size_t c = 0; c < 4; ++c)
    color.push_back(unit(material.base_color[c] * surface.mean[c]));
  if (alpha == AlphaMode::opaque) color[3] = 1.0;

  Json pbr = {{"baseColorFactor", color}};
  if (surface.texture >= 0) pbr["baseColorTexture"] = {{"index", surface.texture}};
  pbr["metallicFactor"] = unit(material.metallic);
  pbr["roughnessFactor"] = unit(material.roughness);
  Json json;
  if (!material.name.empty()) json["name"] = material.name;
  json["pbrMetallicRoughness"] = std::move(pbr);
  if (alpha == AlphaMode::blend) json["alphaMode"] = "BLEND";
  if (alpha == AlphaMode::mask) {
    json["alphaMode"] = "MASK";
    json["alphaCutoff"] = mask_cutoff;
  }
  if (material.glow > 0.0f) {
    json["emissiveFactor"] = Json::array();
    for (std::size_t c = 0; c < 3; ++c)
      json["emissiveFactor"].push_back(unit(material.glow * material.base_color[c] * surface.mean[c]));
    if (surface.texture >= 0) json["emissiveTexture"] = {{"index", surface.texture}};
  }
  if (material.double_sided) json["doubleSided"] = true;
  return json;
}

Result<GlbMaterials::Use> GlbMaterials::use(const Material& material, bool has_uvs) {
  Surface surface;
  if (material.texture && !material.texture->empty() && has_uvs) {
    const auto found = surface_of(material);
    if (!found) return found.error();
    surface = *found;
  }
  Json json = looks(material, surface);
  const std::string text = json_line(json);
  const auto [known, is_new] =
      material_by_text_.try_emplace(text, static_cast<int>(materials_.size()));
  if (is_new) {
    json["name"] = material_names_.take(material.name, "material");
    // Looks are told by words in the name, which may be of any script.
    if (!material.name.empty() && json["name"] != material.name)
      json["extras"] = {{"name", material.name}};
    materials_.push_back(std::move(json));
  }
  return Use{known->second, surface.texture >= 0};
}

void GlbMaterials::finish(Json& gltf) {
  if (!materials_.empty()) gltf["materials"] = std::move(materials_);
  if (images_.empty()) return;
  Json textures = Json::array();
  for (std::size_t i = 0; i < images_.size(); ++i)
    textures.push_back({{"name", images_[i]["name"]}, {"sampler", 0}, {"source", i}});
  gltf["textures"] = std::move(textures);
  gltf["images"] = std::move(images_);
  constexpr int linear = 9729, linear_mipmap_linear = 9987, repeat = 10497;
  gltf["samplers"] = {{{"magFilter", linear},
                       {"minFilter", linear_mipmap_linear},
                       {"wrapS", repeat},
                       {"wrapT", repeat}}};
}

}  // namespace roomgen::detail
