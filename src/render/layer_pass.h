#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "draw_list.h"
#include "pixel_rect.h"
#include "roomgen/view/view.h"

namespace roomgen::detail {

/// A thing to be drawn, by its number.
struct NumberedItem {
  DrawItem item;
  std::uint16_t number = 0;
};

/// Draws what the middle of each pixel shows: depths, normals and numbers of things at one go, without blending and
/// without neighbours. Large pictures are made tile by tile.
class LayerPass {
 public:
  static Result<LayerPass> create(const Gl& gl);

  /// Fills depths, normals and objects, all of the camera's size.
  void draw(const std::vector<NumberedItem>& items, Layers& layers);
  /// How many pixels show the item, among others of the same camera or with nothing else in the picture.
  std::size_t count(const NumberedItem& item, const std::vector<NumberedItem>& among, const Camera& camera);
  std::size_t count_alone(const NumberedItem& item, const Camera& camera);

 private:
  struct Program {
    GlProgram program;
    GLint clip_from_model = -1, camera_from_model = -1, room_from_camera = -1;
    GLint has_eye = -1, thing = -1, least_alpha = -1;
  };
  struct Items {
    const NumberedItem* first;
    std::size_t count;
  };
  using Read = std::function<void(const PixelRect& tile)>;

  explicit LayerPass(const Gl& gl) : gl_(&gl) {}
  Status build(Program& program, const char* defines);
  void reserve(int width, int height);
  std::size_t count_in(const Items& items, const NumberedItem& item, const Camera& camera);
  void draw_tiles(const Items& items, const Camera& camera, const PixelRect& part, const Read& read);
  void clear() const;
  void paint(const Items& items, const Camera& camera, const PixelRect& tile) const;
  void place(const Program& program, const NumberedItem& numbered, const Camera& camera) const;
  void paint_batches(const Program& program, const DrawItem& item) const;
  void read_numbers(const PixelRect& tile);
  void read_surfaces(const PixelRect& tile);

  const Gl* gl_;
  Program plain_, textured_;
  int width_ = 0, height_ = 0;
  GlName surfaces_, numbers_, depth_, framebuffer_;
  std::vector<std::uint32_t> read_numbers_;
  std::vector<Eigen::Vector4f> read_surfaces_;  ///< normal and distance
};

}  // namespace roomgen::detail
