#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gl_objects.h"
#include "lighting.h"
#include "room_lights.h"

namespace roomgen::detail {

/// What lights a picture.
struct SceneLight {
  const Sun* sun;
  GLuint shadow_map;
  double shadow_width;  ///< of its soft edges, in parts of the map's side
  std::vector<RoomLight> lamps = {};  ///< for cameras with an eye
};

/// What is the same for all that is lit in a picture.
struct Sight {
  /// `clip_from_pixel` undoes the viewport.
  Sight(const Camera& camera, const SceneLight& light, const Eigen::Matrix4d& clip_from_pixel);

  const Camera* camera;
  const SceneLight* light;
  Eigen::Matrix4d clip_from_room;
  Eigen::Matrix4f sun_from_pixel, room_from_pixel;
};

/// A program with shaders::lighting before its fragments.
class LitProgram {
 public:
  static constexpr GLint shadow_unit = 7;

  static Result<LitProgram> build(const Gl& gl, const std::string& defines, std::string_view vertex,
                                  std::string_view fragment);

  void use(const Sight& sight) const;
  GLint location(const char* uniform) const { return program_.location(uniform); }

 private:
  void set_lamps(const Sight& sight) const;
  void set_vector(GLint uniform, const Vec3& value) const;

  const Gl* gl_ = nullptr;
  GlProgram program_;
  GLint sun_from_pixel_ = -1, room_from_pixel_ = -1, to_viewer_ = -1, to_sun_ = -1, to_sky_ = -1, shadow_width_ = -1;
  GLint eye_ = -1, light_places_ = -1, light_colors_ = -1, light_axes_ = -1;
};

/// The same program for each number of lamps: that a shader knows their number halves what they cost.
class LitPrograms {
 public:
  using Units = std::vector<std::pair<const char*, GLint>>;  ///< of textures, by the uniforms' names

  /// The sources outlive it.
  LitPrograms(const Gl& gl, std::string defines, std::string_view vertex, std::string_view fragment, Units units)
      : gl_(&gl), defines_(std::move(defines)), vertex_(vertex), fragment_(fragment), units_(std::move(units)) {}

  /// For this sight; built when it is first asked for.
  Result<const LitProgram*> of(const Sight& sight);

 private:
  const Gl* gl_;
  std::string defines_;
  std::string_view vertex_, fragment_;
  Units units_;
  std::map<std::string, LitProgram> built_;  ///< by what defines them
};

}  // namespace roomgen::detail
