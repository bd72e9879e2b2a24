#pragma once

#include <map>
#include <memory>

#include "geometry/alpha.h"
#include "glb_buffer.h"
#include "roomgen/export/exporter.h"
#include "roomgen/geometry/model.h"
#include "scene/plain_names.h"

namespace roomgen::detail {

/// Materials, textures and images of a glTF file, each written once.
class GlbMaterials {
 public:
  GlbMaterials(const ImageEncoder& encode, GlbBuffer& buffer) : encode_(encode), buffer_(buffer) {}

  /// The index of the material, and whether it samples its texture with the mesh's uvs.
  struct Use {
    int index = 0;
    bool textured = false;
  };
  /// `has_uvs` tells whether the mesh can carry a texture.
  Result<Use> use(const Material& material, bool has_uvs);

  /// Fills "materials", "textures", "images" and "samplers" as far as they are used.
  void finish(Json& gltf);

 private:
  struct Surface {
    int texture = -1;                          ///< -1: none
    std::array<float, 4> mean = {1, 1, 1, 1};  ///< linear, for files without textures
    AlphaMode alpha = AlphaMode::opaque;
  };
  Result<Surface> surface_of(const Material& material);
  static Json looks(const Material& material, const Surface& surface);
  Result<int> texture_of(const Image& image, const std::string& material);

  const ImageEncoder& encode_;
  GlbBuffer& buffer_;
  std::map<const Image*, Surface> surfaces_;
  std::vector<std::shared_ptr<const Image>> kept_;  ///< so that addresses stay unique
  std::map<std::string, int> texture_by_hash_;
  std::map<std::string, int> material_by_text_;
  PlainNames material_names_, image_names_;
  Json materials_ = Json::array(), images_ = Json::array();
};

}  // namespace roomgen::detail
