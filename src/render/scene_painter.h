#pragma once

#include <functional>
#include <string>
#include <vector>

#include "draw_list.h"
#include "lighting.h"
#include "pixel_rect.h"
#include "room_lights.h"

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

  struct Light {
    const Sun* sun;
    GLuint shadow_map;
    double shadow_width;  ///< of its soft edges, in parts of the map's side
    std::vector<RoomLight> lamps = {};  ///< for cameras with an eye
  };
  /// Opaque parts first, transparent ones from far to near. `clip_from_pixel` undoes the viewport.
  void paint_surfaces(const DrawList& items, const Camera& camera, const Light& light,
                      const Eigen::Matrix4d& clip_from_pixel, const Visible& visible) const;

 private:
  struct Program {
    GlProgram program;
    GLint clip_from_model = -1, sun_from_pixel = -1, room_from_normal = -1;
    GLint to_viewer = -1, to_sun = -1, to_sky = -1, halfway = -1, shadow_width = -1;
    GLint room_from_pixel = -1, eye = -1;
    GLint lights = -1, light_places = -1, light_colors = -1, light_axes = -1;
  };
  explicit ScenePainter(const Gl& gl) : gl_(&gl) {}
  Status build(Program& program, std::string_view vertex, std::string_view defines,
               std::string_view fragment) const;
  /// The programs of surfaces, for parallel rays or for an eye in the room.
  struct Surfaces {
    Program plain, textured, masked;
    const Program& of(const GpuBatch& batch) const;
  };
  Status build(Surfaces& surfaces, const std::string& defines) const;
  /// What is the same for all surfaces of a picture.
  struct Sight {
    const Camera* camera;
    const Light* light;
    const Surfaces* surfaces;
    Eigen::Matrix4d clip_from_room;
    Eigen::Matrix4f sun_from_pixel, room_from_pixel;
  };
  void use(const Program& program, const Sight& sight) const;
  void place(const Program& program, const DrawItem& item, const Sight& sight) const;
  void paint_opaque(const DrawList& items, const Sight& sight, const Visible& visible) const;
  void paint_transparent(const DrawList& items, const Sight& sight, const Visible& visible) const;
  void paint_depth(const DrawList& items, const Eigen::Matrix4d& clip_from_room,
                   const Visible& visible, const std::function<bool(const GpuBatch&)>& wanted) const;
  void paint_depth_first(const DrawList& items, const Sight& sight, const Visible& visible) const;
  void set_lamps(const Program& program, const Sight& sight) const;
  void set_vector(GLint uniform, const Vec3& value) const;
  void draw(const GpuBatch& batch) const;

  const Gl* gl_;
  Surfaces from_outside_, from_inside_;
  Program depth_, masked_depth_;
};

}  // namespace roomgen::detail
