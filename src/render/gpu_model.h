#pragma once

#include <vector>

#include "geometry/alpha.h"
#include "gl_objects.h"
#include "roomgen/geometry/model.h"

namespace roomgen::detail {

/// Triangles that are drawn with one call.
struct GpuBatch {
  AlphaMode alpha = AlphaMode::opaque;
  GLuint texture = 0;            ///< 0: none
  GLsizei first = 0, count = 0;  ///< indices
  bool casts_shadow = true;
  Vec3 center = Vec3::Zero();  ///< in model coordinates, to sort transparent ones
};

/// A model in the renderer's memory. Parts that differ in colour alone share a batch: the colour is
/// in the vertices.
class GpuModel {
 public:
  GpuModel(const Gl& gl, const Model& model);

  const std::vector<GpuBatch>& batches() const { return batches_; }
  const Bounds3& model_bounds() const { return bounds_; }
  std::size_t bytes() const { return bytes_; }
  void bind(const Gl& gl) const { gl.BindVertexArray(vertex_array_.get()); }

 private:
  struct Arrays;
  GpuBatch add_batch(const Model& model, const std::vector<const ModelPart*>& parts,
                     Arrays& arrays);
  GLuint texture_of(const Gl& gl, const Image* image, Arrays& arrays);
  void upload(const Gl& gl, const Arrays& arrays);

  GlName vertex_array_, vertices_, indices_;
  std::vector<GlName> textures_;
  std::vector<GpuBatch> batches_;
  Bounds3 bounds_;
  std::size_t bytes_ = 0;
};

}  // namespace roomgen::detail
