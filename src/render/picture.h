#pragma once

#include "scene_painter.h"

namespace roomgen::detail {

/// Turns what the painter draws into pixels: draws at twice the size, adds ambient occlusion and
/// brings it down. Large pictures are made tile by tile, so memory does not grow with them.
class Picture {
 public:
  static Result<Picture> create(const Gl& gl);

  /// Replaces the pixels of `part` of the image, which has the camera's size. `continued` says that
  /// the last call drew this picture too and that depths outside `part` are as they were.
  void draw(const ScenePainter& painter, const DrawList& items, const Camera& camera,
            const ScenePainter::Light& light, const PixelRect& part, bool continued, Image& image);

  /// How far an object changes pixels around it.
  static int reach(const Camera& camera);

 private:
  struct Tile {
    PixelRect area;     ///< what the buffers hold: the tile and its surroundings
    PixelRect wanted;   ///< what is read
    PixelRect painted;  ///< what must be drawn for that
  };
  explicit Picture(const Gl& gl) : gl_(&gl) {}
  void reserve(int width, int height);
  void paint(const ScenePainter& painter, const DrawList& items, const Camera& camera,
             const ScenePainter::Light& light, const Tile& tile);
  void add_occlusion(const Camera& camera, const Tile& tile);
  void set_depths(const GlProgram& program, const Camera& camera, const Tile& tile) const;
  void resolve(const Tile& tile, Image& image);
  void set_scissor(const PixelRect& part, const PixelRect& area, int scale) const;

  const Gl* gl_;
  GlProgram occlusion_program_, resolve_program_;
  GlName screen_;  ///< a vertex array without attributes
  int width_ = 0, height_ = 0;
  GlName color_, depth_, surface_buffer_;
  GlName occlusion_, occlusion_buffer_;
  GlName result_, result_buffer_;
};

/// The pixels that a box of the room covers.
PixelRect covered_pixels(const Camera& camera, const Bounds3& box);

}  // namespace roomgen::detail
