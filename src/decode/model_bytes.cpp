#include "model_bytes.h"

#include <algorithm>
#include <map>

#include "bytes.h"
#include "import_limits.h"
#include "unit.h"

namespace roomgen::decode {

namespace {

using Textures = std::vector<std::shared_ptr<const Image>>;

// Each picture once, however many materials show it; -1 is none.
std::map<const Image*, std::int32_t> numbered_textures(const Model& model) {
  std::map<const Image*, std::int32_t> numbers = {{nullptr, -1}};
  for (const auto& material : model.materials)
    numbers.emplace(material.texture.get(), static_cast<std::int32_t>(numbers.size()) - 1);
  return numbers;
}

void put_image(std::string& bytes, const Image& image) {
  put(bytes, image.width);
  put(bytes, image.height);
  put_all(bytes, image.pixels);
}

void put_textures(std::string& bytes, const std::map<const Image*, std::int32_t>& numbers) {
  std::vector<const Image*> images(numbers.size() - 1);
  for (const auto& [image, number] : numbers)
    if (image) images[static_cast<std::size_t>(number)] = image;
  put(bytes, static_cast<std::uint32_t>(images.size()));
  for (const Image* image : images) put_image(bytes, *image);
}

void put_material(std::string& bytes, const Material& material, std::int32_t texture) {
  put_text(bytes, std::string_view(material.name).substr(0, most_name_bytes));
  put(bytes, material.base_color);
  put(bytes, texture);
  put(bytes, material.roughness);
  put(bytes, material.metallic);
  put(bytes, static_cast<std::uint8_t>(material.double_sided));
}

void put_part(std::string& bytes, const ModelPart& part) {
  put(bytes, static_cast<std::uint32_t>(part.material));
  put_all(bytes, part.mesh.positions);
  put_all(bytes, part.mesh.normals);
  put_all(bytes, part.mesh.uvs);
  put_all(bytes, part.mesh.triangles);
}

Image take_image(ByteReader& reader, int max_side) {
  const auto width = reader.take<int>(), height = reader.take<int>();
  const bool fits = width > 0 && height > 0 && width <= max_side && height <= max_side;
  if (!fits) reader.fail();
  const std::size_t size = fits ? 4 * static_cast<std::size_t>(width) * height : 0;
  Image image;
  image.width = width;
  image.height = height;
  image.pixels = reader.take_all<std::uint8_t>(size);
  if (image.pixels.size() != size) reader.fail();
  return image;
}

Textures take_textures(ByteReader& reader, int max_side) {
  const auto count = reader.take<std::uint32_t>();
  if (count > most_materials) reader.fail();
  Textures textures;
  for (std::uint32_t i = 0; i < count && reader.whole(); ++i)
    textures.push_back(std::make_shared<const Image>(take_image(reader, max_side)));
  return textures;
}

Material take_material(ByteReader& reader, const Textures& textures) {
  Material material;
  material.name = reader.take_text(most_name_bytes);
  material.base_color = reader.take<std::array<float, 4>>();
  for (float& value : material.base_color) value = unit(value);
  const auto texture = reader.take<std::int32_t>();
  if (texture >= static_cast<std::int64_t>(textures.size()) || texture < -1)
    reader.fail();
  else if (texture >= 0)
    material.texture = textures[static_cast<std::size_t>(texture)];
  material.roughness = unit(reader.take<float>());
  material.metallic = unit(reader.take<float>());
  material.double_sided = reader.take<std::uint8_t>() != 0;
  return material;
}

bool in_range(const Mesh& mesh) {
  const std::size_t count = mesh.positions.size();
  const auto as_many = [&](std::size_t other) { return other == 0 || other == count; };
  return as_many(mesh.normals.size()) && as_many(mesh.uvs.size()) &&
         std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
           return std::max({t[0], t[1], t[2]}) < count;
         });
}

ModelPart take_part(ByteReader& reader, std::size_t materials, std::size_t max_triangles) {
  ModelPart part;
  const auto material = reader.take<std::uint32_t>();
  if (material >= materials) reader.fail();
  part.material = static_cast<int>(material);
  const std::size_t most_vertices = 3 * max_triangles;
  part.mesh.positions = reader.take_all<Eigen::Vector3f>(most_vertices);
  part.mesh.normals = reader.take_all<Eigen::Vector3f>(most_vertices);
  part.mesh.uvs = reader.take_all<Eigen::Vector2f>(most_vertices);
  part.mesh.triangles = reader.take_all<Triangle>(max_triangles);
  for (auto& uv : part.mesh.uvs)
    if (!uv.allFinite()) uv.setZero();
  if (!in_range(part.mesh)) reader.fail();
  return part;
}

}  // namespace

std::string bytes_of(const Model& model) {
  std::string bytes;
  const auto textures = numbered_textures(model);
  put_textures(bytes, textures);
  put(bytes, static_cast<std::uint32_t>(model.materials.size()));
  for (const auto& material : model.materials)
    put_material(bytes, material, textures.at(material.texture.get()));
  put(bytes, static_cast<std::uint32_t>(model.parts.size()));
  for (const auto& part : model.parts) put_part(bytes, part);
  return bytes;
}

std::string bytes_of(const Image& image) {
  std::string bytes;
  put_image(bytes, image);
  return bytes;
}

Result<Image> image_from(std::string_view bytes, int max_side) {
  ByteReader reader(bytes);
  Image image = take_image(reader, max_side);
  if (!reader.whole() || !reader.at_end())
    return Error{Error::Kind::invalid_input, "the decoder's answer is not a picture"};
  return image;
}

Result<Model> model_from(std::string_view bytes, const ImportOptions& options) {
  ByteReader reader(bytes);
  const Textures textures = take_textures(reader, options.max_texture_side);
  Model model;
  const auto materials = reader.take<std::uint32_t>();
  if (materials > most_materials) reader.fail();
  for (std::uint32_t i = 0; i < materials && reader.whole(); ++i)
    model.materials.push_back(take_material(reader, textures));
  const auto parts = reader.take<std::uint32_t>();
  if (parts > most_materials) reader.fail();
  std::size_t left = options.max_triangles;
  for (std::uint32_t i = 0; i < parts && reader.whole(); ++i) {
    model.parts.push_back(take_part(reader, model.materials.size(), left));
    left -= model.parts.back().mesh.triangles.size();
  }
  if (!reader.whole() || !reader.at_end() || model.parts.empty())
    return Error{Error::Kind::invalid_input, "the decoder's answer is not a model"};
  return model;
}

}  // namespace roomgen::decode
