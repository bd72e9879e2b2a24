#include "import_textures.h"

#include <assimp/GltfMaterial.h>

#include <algorithm>
#include <cmath>

#include "image_decode.h"
#include "roomgen/base/text.h"
#include "unit.h"

namespace roomgen::decode {

namespace {

// Panes written as fully transparent would vanish.
constexpr float least_alpha = 0.15f;

float get(const aiMaterial& source, const char* key, unsigned type, unsigned index,
          float fallback) {
  float value = fallback;
  return source.Get(key, type, index, value) == aiReturn_SUCCESS && std::isfinite(value) ? value
                                                                                         : fallback;
}

// Wavefront shininess to microfacet roughness (Walter et al. 2007, section 5.2: Ns = 2 / a^2 - 2,
// a = roughness^2). A surface without specular colour is dull.
float roughness_from_phong(const aiMaterial& source) {
  aiColor3D specular(0.0f, 0.0f, 0.0f);
  source.Get(AI_MATKEY_COLOR_SPECULAR, specular);
  const float strength = std::max({specular.r, specular.g, specular.b});
  if (!(strength > 0.05f)) return 0.9f;
  const float shininess = std::max(0.0f, get(source, AI_MATKEY_SHININESS, 0.0f));
  return std::clamp(std::sqrt(std::sqrt(2.0f / (shininess + 2.0f))), 0.3f, 0.9f);
}

bool is_picture(const std::string& name) {
  const std::string extension = extension_of(name);
  return extension == "jpg" || extension == "jpeg" || extension == "png";
}

}  // namespace

MaterialReader::MaterialReader(const FileTree& tree, const std::string& mesh, const aiScene& scene,
                               const ImportOptions& options)
    : tree_(tree),
      mesh_(mesh),
      folder_(folder_of(mesh)),
      scene_(scene),
      options_(options),
      is_gltf_(extension_of(mesh) == "gltf" || extension_of(mesh) == "glb") {}

void MaterialReader::warn(const std::string& what) const {
  log(options_.log, LogLevel::warning, mesh_ + ": " + what);
}

Material MaterialReader::read(const aiMaterial& source) {
  Material material;
  material.name = source.GetName().C_Str();
  aiColor4D color(0.8f, 0.8f, 0.8f, 1.0f);
  if (is_gltf_)
    source.Get(AI_MATKEY_BASE_COLOR, color);
  else
    source.Get(AI_MATKEY_COLOR_DIFFUSE, color);
  material.texture = texture(source);

  const float rgb[3] = {color.r, color.g, color.b};
  for (int i = 0; i < 3; ++i) {
    // glTF colours are linear; older formats mean what is seen on screen, and a picture replaces
    // their colour instead of being darkened by it.
    if (is_gltf_)
      material.base_color[i] = unit(rgb[i]);
    else
      material.base_color[i] = material.texture ? 1.0f : linear_from_srgb(255.0f * unit(rgb[i]));
  }
  const float alpha = is_gltf_ ? color.a : get(source, AI_MATKEY_OPACITY, 1.0f);
  material.base_color[3] = std::max(least_alpha, unit(alpha));
  if (is_gltf_) {
    material.roughness = unit(get(source, AI_MATKEY_ROUGHNESS_FACTOR, 0.8f));
    material.metallic = unit(get(source, AI_MATKEY_METALLIC_FACTOR, 0.0f));
    int two_sided = 0;
    source.Get(AI_MATKEY_TWOSIDED, two_sided);
    material.double_sided = two_sided != 0;
  } else {
    material.roughness = roughness_from_phong(source);
    material.double_sided = true;  // older formats do not say, and their winding is unreliable
  }
  return material;
}

std::shared_ptr<const Image> MaterialReader::texture(const aiMaterial& source) {
  aiString path;
  const bool found = source.GetTexture(aiTextureType_BASE_COLOR, 0, &path) == aiReturn_SUCCESS ||
                     source.GetTexture(aiTextureType_DIFFUSE, 0, &path) == aiReturn_SUCCESS;
  const std::string reference(trim(std::string_view(path.C_Str())));
  if (!found || reference.empty()) return nullptr;
  if (const auto known = decoded_.find(reference); known != decoded_.end()) return known->second;

  auto& image = decoded_[reference];
  if (const aiTexture* inside = scene_.GetEmbeddedTexture(reference.c_str()))
    return image = embedded(*inside);
  const std::string file = file_for(reference);
  if (file.empty()) {
    warn("has no texture \"" + file_name_of(reference) + "\"");
    return nullptr;
  }
  const auto bytes = tree_.read(file);
  auto decoded =
      bytes ? decode_image(*bytes, options_.max_texture_side) : Result<Image>(bytes.error());
  if (decoded)
    image = std::make_shared<const Image>(*std::move(decoded));
  else
    warn(file_name_of(file) + ": " + decoded.error().message);
  return image;
}

std::shared_ptr<const Image> MaterialReader::embedded(const aiTexture& source) const {
  if (source.mHeight != 0 || !source.pcData) return nullptr;  // raw pixels: no format that we read
  const std::string_view bytes(reinterpret_cast<const char*>(source.pcData), source.mWidth);
  auto decoded = decode_image(bytes, options_.max_texture_side);
  if (decoded) return std::make_shared<const Image>(*std::move(decoded));
  warn("embedded " + decoded.error().message);
  return nullptr;
}

std::string MaterialReader::file_for(const std::string& reference) const {
  const std::string file = tree_.resolve(folder_, reference);
  return file.empty() ? lone_picture() : file;
}

// A texture that was renamed: take the only picture of a folder that holds one model.
std::string MaterialReader::lone_picture() const {
  std::string picture;
  int meshes = 0;
  for (const auto& name : tree_.files_in(folder_)) {
    if (is_mesh_file(name)) ++meshes;
    if (!is_picture(name)) continue;
    if (!picture.empty()) return {};
    picture = name;
  }
  return meshes == 1 ? picture : std::string();
}

}  // namespace roomgen::decode
