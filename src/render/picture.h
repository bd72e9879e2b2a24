#pragma once

#include "scene_painter.h"

namespace roomgen::detail {

/// What a picture of nothing looks like.
inline constexpr float paper_background[3] = {0.955f, 0.948f, 0.935f};

/// Turns what the painter draws into pixels: draws surfaces at twice the size, finds ambient occlusion, and lights them
/// while it brings them down. Large pictures are made tile by tile, so memory does not grow with them.
class Picture {
 public:
  static Result<Picture> create(const Gl& gl);

  /// Replaces the pixels of `part` of the image, which has the camera's size. `continued` says that
  /// the last call drew this picture too and that depths outside `part` are as they were.
  Status draw(ScenePainter& painter, const DrawList& items, const Camera& camera,
              const SceneLight& light, const PixelRect& part, bool continued, Image& image);

  /// How far an object changes pixels around it.
  static int reach(const Camera& camera);

 private:
  struct Tile {
    PixelRect area;     ///< what the buffers hold: the tile and its surroundings
    PixelRect wanted;   ///< what is read
    PixelRect painted;  ///< what must be drawn for that
  };
  explicit Picture(const Gl& gl);
  void reserve(int width, int height);
  Status paint(ScenePainter& painter, const DrawList& items, const Sight& sight, const Tile& tile);
  void add_occlusion(const Camera& camera, const Tile& tile);
  void set_depths(const GlProgram& program, const Camera& camera, const Tile& tile) const;
  Status light(const Sight& sight, const Tile& tile, Image& image);
  void bind(GLint unit, const GlName& texture) const;
  void set_scissor(const PixelRect& part, const PixelRect& area, int scale) const;

  const Gl* gl_;
  GlProgram occlusion_program_;
  LitPrograms light_programs_;
  GlName screen_;  ///< a vertex array without attributes
  int width_ = 0, height_ = 0;
  GlName paint_, facing_, depth_, surface_buffer_;  ///< at twice the size
  GlName glass_, glass_buffer_;
  GlName occlusion_, occlusion_buffer_;
  GlName result_, result_buffer_;
};

/// The pixels that a box of the room covers.
PixelRect covered_pixels(const Camera& camera, const Bounds3& box);

}  // namespace roomgen::detail
