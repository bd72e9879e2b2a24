#include "scene_painter.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "lit_shaders.h"
#include "shaders.h"

namespace roomgen::detail {

namespace {

constexpr GLint texture_unit = 0;

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

ScenePainter::ScenePainter(const Gl& gl)
    : gl_(&gl),
      plain_glass_(gl, "", shaders::surface_vertex, shaders::glass_fragment, {}),
      textured_glass_(gl, "#define TEXTURED\n", shaders::surface_vertex, shaders::glass_fragment,
                      {{"base_color", texture_unit}}) {}

Result<ScenePainter> ScenePainter::create(const Gl& gl) {
  ScenePainter painter(gl);
  using namespace shaders;
  struct Variant {
    Program* program;
    std::string_view vertex, defines, fragment;
  };
  const Variant variants[] = {
      {&painter.plain_, surface_vertex, "", surface_fragment},
      {&painter.textured_, surface_vertex, "#define TEXTURED\n", surface_fragment},
      {&painter.masked_, surface_vertex, "#define TEXTURED\n#define MASKED\n", surface_fragment},
      {&painter.depth_, shadow_vertex, "", shadow_fragment},
      {&painter.masked_depth_, shadow_vertex, "#define MASKED\n", shadow_fragment}};
  for (const auto& v : variants)
    if (auto status = painter.build(*v.program, v.vertex, v.defines, v.fragment); !status) return status.error();
  return painter;
}

Status ScenePainter::build(Program& program, std::string_view vertex, std::string_view defines,
                           std::string_view fragment) const {
  const std::string source = "#version 400 core\n" + std::string(defines) + std::string(fragment);
  auto built = GlProgram::build(*gl_, vertex, source);
  if (!built) return built.error();
  program.program = std::move(*built);
  program.program.use();
  program.clip_from_model = program.program.location("clip_from_model");
  program.room_from_normal = program.program.location("room_from_normal");
  gl_->Uniform1i(program.program.location("base_color"), texture_unit);
  return {};
}

const ScenePainter::Program& ScenePainter::surface_program(const GpuBatch& batch) const {
  if (!batch.texture) return plain_;
  return batch.alpha == AlphaMode::mask ? masked_ : textured_;
}

void ScenePainter::draw(const GpuBatch& batch) const {
  if (batch.texture) gl_->BindTexture(GL_TEXTURE_2D, batch.texture);
  const auto offset = static_cast<std::size_t>(batch.first) * sizeof(std::uint32_t);
  gl_->DrawElements(GL_TRIANGLES, batch.count, GL_UNSIGNED_INT,
                    reinterpret_cast<const void*>(offset));
}

void ScenePainter::paint_shadows(const DrawList& items, const Eigen::Matrix4d& clip_from_room,
                                 const Visible& visible) const {
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
        if (batch.casts_shadow && masked == (program == &masked_depth_)) draw(batch);
      }
    }
  }
}

void ScenePainter::place(GLint clip_from_model, GLint room_from_normal, const DrawItem& item,
                         const Sight& sight) const {
  const Eigen::Matrix4f matrix = (sight.clip_from_room * item.room_from_model()).cast<float>();
  const Eigen::Matrix3f normal = item.room_from_normal().cast<float>();
  gl_->UniformMatrix4fv(clip_from_model, 1, GL_FALSE, matrix.data());
  gl_->UniformMatrix3fv(room_from_normal, 1, GL_FALSE, normal.data());
  item.model->bind(*gl_);
}

void ScenePainter::paint_surfaces(const DrawList& items, const Sight& sight, const Visible& visible) const {
  gl_->ActiveTexture(GL_TEXTURE0 + texture_unit);
  for (const auto* program : {&plain_, &textured_, &masked_}) {
    program->program.use();
    for (const auto& item : items) {
      if (!visible(item)) continue;
      bool placed = false;
      for (const auto& batch : item.model->batches()) {
        if (batch.alpha == AlphaMode::blend || &surface_program(batch) != program) continue;
        if (!placed) place(program->clip_from_model, program->room_from_normal, item, sight);
        placed = true;
        draw(batch);
      }
    }
  }
}

Status ScenePainter::paint_glass(const DrawList& items, const Sight& sight, const Visible& visible) {
  const auto parts = sorted_transparent(items, *sight.camera, visible);
  // Before anything is switched: a program that cannot be built leaves nothing half done.
  const LitProgram* programs[] = {nullptr, nullptr};  // plain, textured
  const auto of = [&](const auto& part) -> const LitProgram*& { return programs[part.batch->texture ? 1 : 0]; };
  for (const auto& part : parts) {
    if (of(part)) continue;
    const auto program = (part.batch->texture ? textured_glass_ : plain_glass_).of(sight);
    if (!program) return program.error();
    of(part) = *program;
  }
  gl_->Enable(GL_BLEND);
  gl_->BlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_->DepthMask(GL_FALSE);
  for (const auto& part : parts) {
    const LitProgram& program = *of(part);
    program.use(sight);
    place(program.location("clip_from_model"), program.location("room_from_normal"), *part.item, sight);
    draw(*part.batch);
  }
  gl_->DepthMask(GL_TRUE);
  gl_->Disable(GL_BLEND);
  return {};
}

}  // namespace roomgen::detail
