#include "gpu_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>

namespace roomgen::detail {

namespace {

constexpr int largest_texture = 1024;
// Panes fainter than this let the sun through.
constexpr float faintest_shadow = 0.6f;

struct Vertex {
  float position[3];
  std::int16_t normal[4];  ///< the last one is the roughness, below 0 the glow
  float uv[2];
  std::uint8_t color[4];
};
static_assert(sizeof(Vertex) == 32);

std::int16_t to_int16(float value) {
  return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0f, 1.0f) * 32767.0f));
}

Image halved(const Image& image) {
  Image half(std::max(1, image.width / 2), std::max(1, image.height / 2));
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      for (int c = 0; c < 4; ++c) {
        const int x1 = std::min(2 * x + 1, image.width - 1),
                  y1 = std::min(2 * y + 1, image.height - 1);
        const int sum = image.at(std::min(2 * x, x1), std::min(2 * y, y1))[c] +
                        image.at(x1, std::min(2 * y, y1))[c] +
                        image.at(std::min(2 * x, x1), y1)[c] + image.at(x1, y1)[c];
        half.at(x, y)[c] = static_cast<std::uint8_t>((sum + 2) / 4);
      }
  return half;
}

GlName upload_texture(const Gl& gl, const Image& image) {
  if (std::max(image.width, image.height) <= largest_texture) return make_image_texture(gl, image);
  Image smaller = halved(image);
  while (std::max(smaller.width, smaller.height) > largest_texture) smaller = halved(smaller);
  return make_image_texture(gl, smaller);
}

// Parts that can be drawn together.
struct BatchKey {
  const Image* texture;
  AlphaMode alpha;
  int order;  ///< transparent parts stay apart, to be sorted; textures in order of appearance

  auto operator<=>(const BatchKey& other) const {
    return std::tuple(alpha, order) <=> std::tuple(other.alpha, other.order);
  }
};

void add_vertices(std::vector<Vertex>& vertices, const Mesh& mesh, const Material& material) {
  const bool has_normals = mesh.normals.size() == mesh.positions.size();
  const bool has_uvs = mesh.uvs.size() == mesh.positions.size();
  std::array<std::uint8_t, 4> color{};
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = static_cast<std::uint8_t>(std::lround(srgb255_from_linear(material.base_color[c])));
  color[3] = static_cast<std::uint8_t>(
      std::lround(255.0f * std::clamp(material.base_color[3], 0.0f, 1.0f)));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    Vertex v{};
    for (int axis = 0; axis < 3; ++axis) {
      v.position[axis] = mesh.positions[i][axis];
      v.normal[axis] = to_int16(has_normals ? mesh.normals[i][axis] : axis == 2 ? 1.0f : 0.0f);
    }
    v.normal[3] = to_int16(material.glow > 0.0f ? -material.glow : material.roughness);
    if (has_uvs)
      for (int axis = 0; axis < 2; ++axis) v.uv[axis] = mesh.uvs[i][axis];
    std::copy(color.begin(), color.end(), v.color);
    vertices.push_back(v);
  }
}

void describe_vertices(const Gl& gl) {
  const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  constexpr GLsizei stride = sizeof(Vertex);
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, offset(offsetof(Vertex, position)));
  gl.VertexAttribPointer(1, 4, GL_SHORT, GL_TRUE, stride, offset(offsetof(Vertex, normal)));
  gl.VertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, stride, offset(offsetof(Vertex, uv)));
  gl.VertexAttribPointer(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, offset(offsetof(Vertex, color)));
  for (GLuint attribute = 0; attribute < 4; ++attribute) gl.EnableVertexAttribArray(attribute);
}

std::map<BatchKey, std::vector<const ModelPart*>> sort_parts(const Model& model) {
  std::vector<AlphaMode> modes;
  for (const auto& material : model.materials) modes.push_back(alpha_mode(material));
  std::map<const Image*, int> texture_order;
  std::map<BatchKey, std::vector<const ModelPart*>> sorted;
  int number = 0;
  for (const auto& part : model.parts) {
    const auto index = static_cast<std::size_t>(part.material);
    const Image* image = model.materials[index].texture.get();
    if (part.mesh.uvs.empty()) image = nullptr;
    int order =
        texture_order.try_emplace(image, static_cast<int>(texture_order.size())).first->second;
    if (modes[index] == AlphaMode::blend) order = 1000000 + number++;
    sorted[{image, modes[index], order}].push_back(&part);
  }
  return sorted;
}

}  // namespace

// What is gathered before it goes to OpenGL.
struct GpuModel::Arrays {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  std::map<const Image*, GLuint> textures;
};

GpuModel::GpuModel(const Gl& gl, const Model& model) : bounds_(bounds(model)) {
  Arrays arrays;
  for (const auto& [key, parts] : sort_parts(model)) {
    GpuBatch batch = add_batch(model, parts, arrays);
    if (batch.count == 0) continue;
    batch.alpha = key.alpha;
    batch.texture = texture_of(gl, key.texture, arrays);
    batches_.push_back(batch);
  }
  upload(gl, arrays);
}

GpuBatch GpuModel::add_batch(const Model& model, const std::vector<const ModelPart*>& parts,
                             Arrays& arrays) {
  GpuBatch batch;
  batch.first = static_cast<GLsizei>(arrays.indices.size());
  Bounds3 extent;
  for (const auto* part : parts) {
    const Material& material = model.materials[static_cast<std::size_t>(part->material)];
    const auto base = static_cast<std::uint32_t>(arrays.vertices.size());
    add_vertices(arrays.vertices, part->mesh, material);
    for (const auto& triangle : part->mesh.triangles)
      for (const auto v : triangle) arrays.indices.push_back(base + v);
    for (const auto& p : part->mesh.positions) extent.add(p.cast<double>());
    if (material.base_color[3] < faintest_shadow) batch.casts_shadow = false;
  }
  batch.count = static_cast<GLsizei>(arrays.indices.size()) - batch.first;
  if (!extent.empty()) batch.center = extent.center();
  return batch;
}

GLuint GpuModel::texture_of(const Gl& gl, const Image* image, Arrays& arrays) {
  if (!image || image->empty()) return 0;
  auto& texture = arrays.textures[image];
  if (!texture) {
    textures_.push_back(upload_texture(gl, *image));
    texture = textures_.back().get();
    bytes_ += image->pixels.size() * 4 / 3;  // with its mipmaps
  }
  return texture;
}

void GpuModel::upload(const Gl& gl, const Arrays& arrays) {
  const auto vertex_bytes = arrays.vertices.size() * sizeof(Vertex);
  const auto index_bytes = arrays.indices.size() * sizeof(std::uint32_t);
  vertex_array_ = make_vertex_array(gl);
  gl.BindVertexArray(vertex_array_.get());
  vertices_ = make_buffer(gl);
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.get());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertex_bytes), arrays.vertices.data(),
                GL_STATIC_DRAW);
  indices_ = make_buffer(gl);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(index_bytes),
                arrays.indices.data(), GL_STATIC_DRAW);
  describe_vertices(gl);
  gl.BindVertexArray(0);
  bytes_ += vertex_bytes + index_bytes;
}

}  // namespace roomgen::detail
