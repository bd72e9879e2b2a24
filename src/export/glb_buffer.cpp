#include "glb_buffer.h"

#include <bit>
#include <cstdint>
#include <cstring>

namespace roomgen::detail {

namespace {

static_assert(std::endian::native == std::endian::little, "GLB is little-endian");

constexpr int component_float = 5126, component_uint16 = 5123, component_uint32 = 5125;
constexpr int target_vertices = 34962, target_indices = 34963;

template <typename T>
void append_value(std::string& bytes, const T& value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

template <typename Vector>
void append_vectors(std::string& bytes, const std::vector<Vector>& values) {
  for (const auto& v : values)
    for (int axis = 0; axis < v.size(); ++axis) append_value(bytes, static_cast<float>(v[axis]));
}

void pad(std::string& bytes, char filler) {
  while (bytes.size() % 4) bytes += filler;
}

}  // namespace

int GlbBuffer::add_accessor(Kind kind, int component_type, std::size_t count, const char* type) {
  // bufferView is a kind until finish() knows which of them are used.
  accessors_.push_back({{"bufferView", 0},
                        {"byteOffset", data_[kind].size()},
                        {"componentType", component_type},
                        {"count", count},
                        {"type", type}});
  accessor_kinds_.push_back(kind);
  return static_cast<int>(accessors_.size()) - 1;
}

int GlbBuffer::add_positions(const std::vector<Eigen::Vector3f>& values) {
  const int index = add_accessor(vectors3, component_float, values.size(), "VEC3");
  Eigen::Vector3f low = values.front(), high = values.front();
  for (const auto& v : values) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  accessors_.back()["min"] = {low.x(), low.y(), low.z()};
  accessors_.back()["max"] = {high.x(), high.y(), high.z()};
  append_vectors(data_[vectors3], values);
  return index;
}

int GlbBuffer::add_normals(const std::vector<Eigen::Vector3f>& values) {
  const int index = add_accessor(vectors3, component_float, values.size(), "VEC3");
  append_vectors(data_[vectors3], values);
  return index;
}

int GlbBuffer::add_uvs(const std::vector<Eigen::Vector2f>& values) {
  const int index = add_accessor(vectors2, component_float, values.size(), "VEC2");
  append_vectors(data_[vectors2], values);
  return index;
}

int GlbBuffer::add_indices(const std::vector<Triangle>& triangles, std::size_t vertex_count) {
  // 65535 itself would mean "restart".
  const bool is_short = vertex_count < 65535;
  const Kind kind = is_short ? short_indices : long_indices;
  const int index = add_accessor(kind, is_short ? component_uint16 : component_uint32,
                                 3 * triangles.size(), "SCALAR");
  for (const auto& triangle : triangles)
    for (const auto v : triangle) {
      if (is_short)
        append_value(data_[kind], static_cast<std::uint16_t>(v));
      else
        append_value(data_[kind], v);
    }
  return index;
}

int GlbBuffer::add_image(const std::string& bytes) {
  images_.push_back(bytes);
  return static_cast<int>(images_.size()) - 1;
}

std::string GlbBuffer::finish(Json& gltf) {
  std::string binary;
  Json views = Json::array();
  const auto add_view = [&](const std::string& bytes) -> Json& {
    pad(binary, '\0');
    views.push_back({{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}});
    binary += bytes;
    return views.back();
  };
  for (const auto& image : images_) add_view(image);
  std::array<int, kinds> view_of_kind{};
  for (int kind = 0; kind < kinds; ++kind) {
    const auto k = static_cast<std::size_t>(kind);
    if (data_[k].empty()) continue;
    view_of_kind[k] = static_cast<int>(views.size());
    Json& view = add_view(data_[k]);
    if (kind == vectors3) view["byteStride"] = 12;
    if (kind == vectors2) view["byteStride"] = 8;
    view["target"] = kind == vectors3 || kind == vectors2 ? target_vertices : target_indices;
  }
  for (std::size_t i = 0; i < accessor_kinds_.size(); ++i)
    accessors_[i]["bufferView"] = view_of_kind[accessor_kinds_[i]];
  pad(binary, '\0');
  if (!accessors_.empty()) gltf["accessors"] = std::move(accessors_);
  if (!views.empty()) {
    gltf["bufferViews"] = std::move(views);
    gltf["buffers"] = {{{"byteLength", binary.size()}}};
  }
  return binary;
}

std::string glb_file(const Json& gltf, std::string binary) {
  // Names come from strangers' files: what is not UTF-8 is replaced rather than refused.
  std::string text = json_line(gltf);
  pad(text, ' ');
  pad(binary, '\0');
  std::string file = "glTF";
  append_value(file, std::uint32_t{2});
  const std::size_t binary_chunk = binary.empty() ? 0 : 8 + binary.size();
  append_value(file, static_cast<std::uint32_t>(12 + 8 + text.size() + binary_chunk));
  append_value(file, static_cast<std::uint32_t>(text.size()));
  file += "JSON" + text;
  if (binary.empty()) return file;
  append_value(file, static_cast<std::uint32_t>(binary.size()));
  file.append("BIN\0", 4);
  return file + binary;
}

}  // namespace roomgen::detail
