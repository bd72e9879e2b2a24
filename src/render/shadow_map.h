#pragma once

#include "scene_painter.h"

namespace roomgen::detail {

/// What the sun sees, as depths.
class ShadowMap {
 public:
  explicit ShadowMap(const Gl& gl);

  static PixelRect whole() { return {0, 0, size, size}; }
  /// Metres between its samples.
  static double texel(const Sun& sun) { return sun.extent / size; }
  /// The part that a box of the room covers.
  static PixelRect covered_by(const Sun& sun, const Bounds3& box);
  /// Draws the items into this part, which forgets what it held.
  void update(const ScenePainter& painter, const DrawList& items, const Sun& sun,
              const PixelRect& part);
  GLuint texture() const { return depth_.get(); }

 private:
  static constexpr int size = 1024;

  const Gl* gl_;
  GlName depth_, framebuffer_;
};

}  // namespace roomgen::detail
