#include "lit_program.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "lit_shaders.h"

namespace roomgen::detail {

namespace {

Eigen::Matrix4d texture_from_clip() {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.diagonal() << 0.5, 0.5, 0.5, 1.0;
  m.topRightCorner<3, 1>().setConstant(0.5);
  return m;
}

std::size_t lamps_of(const Sight& sight) { return std::min(sight.light->lamps.size(), most_room_lights); }

std::string defines_of(const Sight& sight) {
  if (!sight.camera->eye) return "";
  const auto& lamps = sight.light->lamps;
  const auto windows = std::count_if(lamps.begin(), lamps.end(), [](const RoomLight& lamp) { return lamp.is_window; });
  return "#define INDOORS\n#define LIGHTS " + std::to_string(lamps_of(sight)) + "\n#define WINDOWS " +
         std::to_string(windows) + "\n";
}

}  // namespace

Sight::Sight(const Camera& seen_by, const SceneLight& lit_by, const Eigen::Matrix4d& clip_from_pixel)
    : camera(&seen_by), light(&lit_by), clip_from_room(detail::clip_from_room(seen_by)) {
  const Eigen::Matrix4d from_pixel = clip_from_room.inverse() * clip_from_pixel;
  sun_from_pixel = (texture_from_clip() * light->sun->clip_from_room * from_pixel).cast<float>();
  room_from_pixel = from_pixel.cast<float>();
}

Result<LitProgram> LitProgram::build(const Gl& gl, const std::string& defines, std::string_view vertex,
                                     std::string_view fragment) {
  const std::string head = "#version 400 core\n" + defines;
  auto built = GlProgram::build(gl, vertex, head + std::string(shaders::lighting) + std::string(fragment));
  if (!built) return built.error();
  LitProgram lit;
  lit.gl_ = &gl;
  lit.program_ = std::move(*built);
  const std::pair<GLint*, const char*> uniforms[] = {
      {&lit.sun_from_pixel_, "sun_from_pixel"}, {&lit.room_from_pixel_, "room_from_pixel"},
      {&lit.to_viewer_, "to_viewer"}, {&lit.to_sun_, "to_sun"}, {&lit.to_sky_, "to_sky"},
      {&lit.shadow_width_, "shadow_width"}, {&lit.eye_, "eye"},
      {&lit.light_places_, "light_places"}, {&lit.light_colors_, "light_colors"}, {&lit.light_axes_, "light_axes"}};
  for (const auto& [uniform, name] : uniforms) *uniform = lit.location(name);
  lit.program_.use();
  gl.Uniform1i(lit.location("sun_depth"), shadow_unit);
  return lit;
}

void LitProgram::set_vector(GLint uniform, const Vec3& value) const {
  const Eigen::Vector3f v = value.cast<float>();
  gl_->Uniform3f(uniform, v.x(), v.y(), v.z());
}

void LitProgram::use(const Sight& sight) const {
  const Vec3& to_viewer = sight.camera->backward;
  program_.use();
  gl_->ActiveTexture(GL_TEXTURE0 + shadow_unit);
  gl_->BindTexture(GL_TEXTURE_2D, sight.light->shadow_map);
  gl_->ActiveTexture(GL_TEXTURE0);
  gl_->UniformMatrix4fv(sun_from_pixel_, 1, GL_FALSE, sight.sun_from_pixel.data());
  gl_->UniformMatrix4fv(room_from_pixel_, 1, GL_FALSE, sight.room_from_pixel.data());
  set_vector(to_viewer_, to_viewer);
  set_vector(to_sun_, sight.light->sun->direction);
  // Seen from inside, a ceiling is as bright as the floor: light comes back from everywhere.
  const Vec3 above = sight.camera->eye ? Vec3(Vec3::Zero()) : Vec3(0.6 * Vec3::UnitZ());
  set_vector(to_sky_, (to_viewer + above).normalized());
  gl_->Uniform1f(shadow_width_, static_cast<float>(sight.light->shadow_width));
  if (sight.camera->eye) set_lamps(sight);
}

void LitProgram::set_lamps(const Sight& sight) const {
  std::vector<Eigen::Vector3f> places, colors;
  std::vector<Eigen::Vector4f> axes;
  for (const auto& lamp : sight.light->lamps) {
    places.push_back(lamp.place.cast<float>());
    colors.push_back(lamp.color);
    const Eigen::Vector3f axis = lamp.axis.cast<float>();
    axes.emplace_back(axis.x(), axis.y(), axis.z(), static_cast<float>(lamp.cosine));
  }
  const auto count = static_cast<GLsizei>(lamps_of(sight));
  set_vector(eye_, *sight.camera->eye);
  if (count == 0) return;
  gl_->Uniform3fv(light_places_, count, places.front().data());
  gl_->Uniform3fv(light_colors_, count, colors.front().data());
  gl_->Uniform4fv(light_axes_, count, axes.front().data());
}

Result<const LitProgram*> LitPrograms::of(const Sight& sight) {
  const std::string defines = defines_of(sight) + defines_;
  const auto known = built_.find(defines);
  if (known != built_.end()) return &known->second;
  auto program = LitProgram::build(*gl_, defines, vertex_, fragment_);
  if (!program) return program.error();
  for (const auto& [name, unit] : units_) gl_->Uniform1i(program->location(name), unit);
  return &built_.emplace(defines, std::move(*program)).first->second;
}

}  // namespace roomgen::detail
