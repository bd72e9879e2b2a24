#pragma once

#include <functional>

#include "draw_list.h"
#include "lit_program.h"
#include "pixel_rect.h"

namespace roomgen::detail {

/// Draws models into the current framebuffer, as the sun or the camera sees them.
class ScenePainter {
 public:
  static Result<ScenePainter> create(const Gl& gl);

  /// What may be seen of an item, in pixels of the target.
  using Visible = std::function<bool(const DrawItem&)>;

  /// What casts shadows.
  void paint_shadows(const DrawList& items, const Eigen::Matrix4d& clip_from_room,
                     const Visible& visible) const;

  /// What is not transparent: what it is painted like and which way it faces.
  void paint_surfaces(const DrawList& items, const Sight& sight, const Visible& visible) const;
  /// Transparent parts from far to near, lit.
  Status paint_glass(const DrawList& items, const Sight& sight, const Visible& visible);

 private:
  struct Program {
    GlProgram program;
    GLint clip_from_model = -1, room_from_normal = -1;
  };
  explicit ScenePainter(const Gl& gl);
  Status build(Program& program, std::string_view vertex, std::string_view defines,
               std::string_view fragment) const;
  void place(GLint clip_from_model, GLint room_from_normal, const DrawItem& item, const Sight& sight) const;
  const Program& surface_program(const GpuBatch& batch) const;
  void draw(const GpuBatch& batch) const;

  const Gl* gl_;
  Program plain_, textured_, masked_;
  Program depth_, masked_depth_;
  LitPrograms plain_glass_, textured_glass_;
};

}  // namespace roomgen::detail
