#include "scene_painter.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "shaders.h"

namespace roomgen::detail {

namespace {

constexpr GLint texture_unit = 0, shadow_unit = 1;

Eigen::Matrix4d texture_from_clip() {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.diagonal() << 0.5, 0.5, 0.5, 1.0;
  m.topRightCorner<3, 1>().setConstant(0.5);
  return m;
}

struct Transparent {
  const DrawItem* item;
  const GpuBatch* batch;
  double depth;
};

// Far to near; equal depths in the order of the scene.
std::vector<Transparent> sorted_transparent(const DrawList& items, const Camera& camera,
                                            const ScenePainter::Visible& visible) {
  std::vector<Transparent> result;
  for (const auto& item : items)
    for (const auto& batch : item.model->batches()) {
      if (batch.alpha != AlphaMode::blend || !visible(item)) continue;
      const Vec3 center = (item.room_from_model() * batch.center.homogeneous()).head<3>();
      result.push_back({&item, &batch, camera.depth(center)});
    }
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.depth < b.depth; });
  return result;
}

}  // namespace

Result<ScenePainter> ScenePainter::create(const Gl& gl) {
  ScenePainter painter(gl);
  if (auto status = painter.build(painter.from_outside_, ""); !status) return status.error();
  if (auto status = painter.build(painter.from_inside_, "#define INDOORS\n"); !status)
    return status.error();
  if (auto status =
          painter.build(painter.depth_, shaders::shadow_vertex, "", shaders::shadow_fragment);
      !status)
    return status.error();
  if (auto status = painter.build(painter.masked_depth_, shaders::shadow_vertex,
                                  "#define MASKED\n", shaders::shadow_fragment);
      !status)
    return status.error();
  return painter;
}

Status ScenePainter::build(Surfaces& surfaces, const std::string& defines) const {
  const std::pair<Program*, const char*> variants[] = {
      {&surfaces.plain, ""},
      {&surfaces.textured, "#define TEXTURED\n"},
      {&surfaces.masked, "#define TEXTURED\n#define MASKED\n"}};
  for (const auto& [program, variant] : variants)
    if (auto status = build(*program, shaders::surface_vertex, defines + variant,
                            shaders::surface_fragment);
        !status)
      return status;
  return {};
}

Status ScenePainter::build(Program& program, std::string_view vertex, std::string_view defines,
                           std::string_view fragment) const {
  const std::string source = "#version 400 core\n" + std::string(defines) + std::string(fragment);
  auto built = GlProgram::build(*gl_, vertex, source);
  if (!built) return built.error();
  program.program = std::move(*built);
  program.program.use();
  const std::pair<GLint*, const char*> uniforms[] = {
      {&program.clip_from_model, "clip_from_model"}, {&program.sun_from_pixel, "sun_from_pixel"},
      {&program.room_from_normal, "room_from_normal"}, {&program.to_viewer, "to_viewer"},
      {&program.to_sun, "to_sun"}, {&program.to_sky, "to_sky"}, {&program.halfway, "halfway"},
      {&program.shadow_width, "shadow_width"}, {&program.room_from_pixel, "room_from_pixel"},
      {&program.eye, "eye"}, {&program.lights, "lights"}, {&program.light_places, "light_places"},
      {&program.light_colors, "light_colors"}, {&program.light_axes, "light_axes"}};
  for (const auto& [uniform, name] : uniforms) *uniform = program.program.location(name);
  gl_->Uniform1i(program.program.location("base_color"), texture_unit);
  gl_->Uniform1i(program.program.location("sun_depth"), shadow_unit);
  return {};
}

const ScenePainter::Program& ScenePainter::Surfaces::of(const GpuBatch& batch) const {
  if (!batch.texture) return plain;
  return batch.alpha == AlphaMode::mask ? masked : textured;
}

void ScenePainter::draw(const GpuBatch& batch) const {
  if (batch.texture) gl_->BindTexture(GL_TEXTURE_2D, batch.texture);
  const auto offset = static_cast<std::size_t>(batch.first) * sizeof(std::uint32_t);
  gl_->DrawElements(GL_TRIANGLES, batch.count, GL_UNSIGNED_INT,
                    reinterpret_cast<const void*>(offset));
}

void ScenePainter::paint_shadows(const DrawList& items, const Eigen::Matrix4d& clip_from_room,
                                 const Visible& visible) const {
  paint_depth(items, clip_from_room, visible,
              [](const GpuBatch& batch) { return batch.casts_shadow; });
}

void ScenePainter::paint_depth(const DrawList& items, const Eigen::Matrix4d& clip_from_room,
                               const Visible& visible,
                               const std::function<bool(const GpuBatch&)>& wanted) const {
  gl_->ActiveTexture(GL_TEXTURE0 + texture_unit);
  for (const auto* program : {&depth_, &masked_depth_}) {
    program->program.use();
    for (const auto& item : items) {
      if (!visible(item)) continue;
      const Eigen::Matrix4f matrix = (clip_from_room * item.room_from_model()).cast<float>();
      gl_->UniformMatrix4fv(program->clip_from_model, 1, GL_FALSE, matrix.data());
      item.model->bind(*gl_);
      for (const auto& batch : item.model->batches()) {
        const bool masked = batch.alpha == AlphaMode::mask && batch.texture;
        if (wanted(batch) && masked == (program == &masked_depth_)) draw(batch);
      }
    }
  }
}

void ScenePainter::paint_surfaces(const DrawList& items, const Camera& camera, const Light& light,
                                  const Eigen::Matrix4d& clip_from_pixel,
                                  const Visible& visible) const {
  Sight sight{&camera, &light, camera.eye ? &from_inside_ : &from_outside_, clip_from_room(camera),
              {}, {}};
  const Eigen::Matrix4d room_from_pixel = sight.clip_from_room.inverse() * clip_from_pixel;
  sight.sun_from_pixel =
      (texture_from_clip() * light.sun->clip_from_room * room_from_pixel).cast<float>();
  sight.room_from_pixel = room_from_pixel.cast<float>();
  gl_->ActiveTexture(GL_TEXTURE0 + shadow_unit);
  gl_->BindTexture(GL_TEXTURE_2D, light.shadow_map);
  gl_->ActiveTexture(GL_TEXTURE0 + texture_unit);
  if (camera.eye) paint_depth_first(items, sight, visible);
  paint_opaque(items, sight, visible);
  gl_->DepthFunc(GL_LESS);
  paint_transparent(items, sight, visible);
}

// In a room much stands behind other things, and light is dear: it falls only on what is seen.
void ScenePainter::paint_depth_first(const DrawList& items, const Sight& sight,
                                     const Visible& visible) const {
  gl_->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  paint_depth(items, sight.clip_from_room, visible,
              [](const GpuBatch& batch) { return batch.alpha != AlphaMode::blend; });
  gl_->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_->DepthFunc(GL_LEQUAL);
}

void ScenePainter::set_vector(GLint uniform, const Vec3& value) const {
  const Eigen::Vector3f v = value.cast<float>();
  gl_->Uniform3f(uniform, v.x(), v.y(), v.z());
}

void ScenePainter::use(const Program& program, const Sight& sight) const {
  const Vec3 &to_viewer = sight.camera->backward, &to_sun = sight.light->sun->direction;
  program.program.use();
  gl_->UniformMatrix4fv(program.sun_from_pixel, 1, GL_FALSE, sight.sun_from_pixel.data());
  set_vector(program.to_viewer, to_viewer);
  set_vector(program.to_sun, to_sun);
  // Seen from inside, a ceiling is as bright as the floor: light comes back from everywhere.
  const Vec3 above = sight.camera->eye ? Vec3(Vec3::Zero()) : Vec3(0.6 * Vec3::UnitZ());
  set_vector(program.to_sky, (to_viewer + above).normalized());
  set_vector(program.halfway, (to_sun + to_viewer).normalized());
  gl_->Uniform1f(program.shadow_width, static_cast<float>(sight.light->shadow_width));
  if (sight.camera->eye) set_lamps(program, sight);
}

void ScenePainter::set_lamps(const Program& program, const Sight& sight) const {
  std::vector<Eigen::Vector3f> places, colors;
  std::vector<Eigen::Vector4f> axes;
  for (const auto& lamp : sight.light->lamps) {
    places.push_back(lamp.place.cast<float>());
    colors.push_back(lamp.color);
    const Eigen::Vector3f axis = lamp.axis.cast<float>();
    axes.emplace_back(axis.x(), axis.y(), axis.z(), static_cast<float>(lamp.cosine));
  }
  const auto count = static_cast<GLsizei>(std::min(places.size(), most_room_lights));
  gl_->UniformMatrix4fv(program.room_from_pixel, 1, GL_FALSE, sight.room_from_pixel.data());
  set_vector(program.eye, *sight.camera->eye);
  gl_->Uniform1i(program.lights, count);
  if (count == 0) return;
  gl_->Uniform3fv(program.light_places, count, places.front().data());
  gl_->Uniform3fv(program.light_colors, count, colors.front().data());
  gl_->Uniform4fv(program.light_axes, count, axes.front().data());
}

void ScenePainter::place(const Program& program, const DrawItem& item, const Sight& sight) const {
  const Eigen::Matrix4f matrix = (sight.clip_from_room * item.room_from_model()).cast<float>();
  const Eigen::Matrix3f normal = item.room_from_normal().cast<float>();
  gl_->UniformMatrix4fv(program.clip_from_model, 1, GL_FALSE, matrix.data());
  gl_->UniformMatrix3fv(program.room_from_normal, 1, GL_FALSE, normal.data());
  item.model->bind(*gl_);
}

void ScenePainter::paint_opaque(const DrawList& items, const Sight& sight,
                                const Visible& visible) const {
  const Surfaces& surfaces = *sight.surfaces;
  for (const auto* program : {&surfaces.plain, &surfaces.textured, &surfaces.masked}) {
    use(*program, sight);
    for (const auto& item : items) {
      if (!visible(item)) continue;
      bool placed = false;
      for (const auto& batch : item.model->batches()) {
        if (batch.alpha == AlphaMode::blend || &surfaces.of(batch) != program) continue;
        if (!placed) place(*program, item, sight);
        placed = true;
        draw(batch);
      }
    }
  }
}

void ScenePainter::paint_transparent(const DrawList& items, const Sight& sight,
                                     const Visible& visible) const {
  gl_->Enable(GL_BLEND);
  gl_->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_->DepthMask(GL_FALSE);
  for (const auto& part : sorted_transparent(items, *sight.camera, visible)) {
    const Program& program = sight.surfaces->of(*part.batch);
    use(program, sight);
    place(program, *part.item, sight);
    draw(*part.batch);
  }
  gl_->DepthMask(GL_TRUE);
  gl_->Disable(GL_BLEND);
}

}  // namespace roomgen::detail
