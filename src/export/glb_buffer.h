#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "roomgen/base/json.h"
#include "roomgen/geometry/model.h"

namespace roomgen::detail {

/// The binary chunk of a GLB file: vertex data of a kind lies together, in one buffer view each.
class GlbBuffer {
 public:
  // Each returns the index of a new accessor.
  int add_positions(const std::vector<Eigen::Vector3f>& values);  ///< with min and max
  int add_normals(const std::vector<Eigen::Vector3f>& values);
  int add_uvs(const std::vector<Eigen::Vector2f>& values);
  int add_indices(const std::vector<Triangle>& triangles, std::size_t vertex_count);
  /// Returns the index of the image's buffer view, which later calls do not change.
  int add_image(const std::string& bytes);

  /// Fills "accessors", "bufferViews" and "buffers" and returns the chunk. Ends the use of the
  /// buffer.
  std::string finish(Json& gltf);

 private:
  enum Kind { vectors3, vectors2, short_indices, long_indices, kinds };
  int add_accessor(Kind kind, int component_type, std::size_t count, const char* type);

  std::array<std::string, kinds> data_;
  std::vector<std::string> images_;
  Json accessors_ = Json::array();
  std::vector<Kind> accessor_kinds_;
};

/// The container: 12 bytes of header, the JSON chunk, the binary chunk (glTF 2.0, section 4.4).
std::string glb_file(const Json& gltf, std::string binary);

}  // namespace roomgen::detail
