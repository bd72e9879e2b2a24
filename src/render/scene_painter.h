#pragma once

#include <functional>

#include "draw_list.h"
#include "lighting.h"
#include "pixel_rect.h"

namespace roomgen::detail {

/// Draws models into the current framebuffer, as the sun or the camera sees them.
class ScenePainter {
 public:
  static Result<ScenePainter> create(const Gl& gl);

  /// What may be seen of an item, in pixels of the target.
  using Visible = std::function<bool(const DrawItem&)>;

  void paint_depth(const DrawList& items, const Eigen::Matrix4d& clip_from_room,
                   const Visible& visible) const;

  struct Light {
    const Sun* sun;
    GLuint shadow_map;
    double shadow_width;  ///< of its soft edges, in parts of the map's side
  };
  /// Opaque parts first, transparent ones from far to near. `clip_from_pixel` undoes the viewport.
  void paint_surfaces(const DrawList& items, const Camera& camera, const Light& light,
                      const Eigen::Matrix4d& clip_from_pixel, const Visible& visible) const;

 private:
  struct Program {
    GlProgram program;
    GLint clip_from_model = -1, sun_from_pixel = -1, room_from_normal = -1;
    GLint to_viewer = -1, to_sun = -1, to_sky = -1, halfway = -1, shadow_width = -1;
  };
  explicit ScenePainter(const Gl& gl) : gl_(&gl) {}
  Status build(Program& program, std::string_view vertex, std::string_view defines,
               std::string_view fragment) const;
  const Program& surface_program(const GpuBatch& batch) const;
  /// What is the same for all surfaces of a picture.
  struct Sight {
    const Camera* camera;
    const Light* light;
    Eigen::Matrix4d clip_from_room;
    Eigen::Matrix4f sun_from_pixel;
  };
  void use(const Program& program, const Sight& sight) const;
  void place(const Program& program, const DrawItem& item, const Sight& sight) const;
  void paint_opaque(const DrawList& items, const Sight& sight, const Visible& visible) const;
  void paint_transparent(const DrawList& items, const Sight& sight, const Visible& visible) const;
  void set_vector(GLint uniform, const Vec3& value) const;
  void draw(const GpuBatch& batch) const;

  const Gl* gl_;
  Program plain_, textured_, masked_;
  Program depth_, masked_depth_;
};

}  // namespace roomgen::detail
