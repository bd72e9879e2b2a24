#include "layer_pass.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <string>

#include "lighting.h"
#include "picture.h"
#include "shaders.h"

namespace roomgen::detail {

namespace {

constexpr int layer_tile_side = 1024;
// A texel of foliage is there or not as in the picture; of glass and curtains all but what nobody sees.
constexpr float least_masked_alpha = 0.4f, least_blended_alpha = 0.05f;

float least_alpha(AlphaMode mode) {
  switch (mode) {
    case AlphaMode::opaque: return 0.0f;
    case AlphaMode::mask: return least_masked_alpha;
    case AlphaMode::blend: return least_blended_alpha;
  }
  return 0.0f;
}

Eigen::Matrix3d room_from_camera(const Camera& camera) {
  Eigen::Matrix3d turn;
  turn << camera.right, camera.up, camera.backward;
  return turn;
}

Eigen::Matrix4d camera_from_room(const Camera& camera) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  const Eigen::Matrix3d turn = room_from_camera(camera).transpose();
  m.topLeftCorner<3, 3>() = turn;
  m.topRightCorner<3, 1>() = -turn * camera.origin();
  return m;
}

struct DepthRange {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
};

// Metres along the axis of the camera.
DepthRange distances(const Camera& camera, const Bounds3& box) {
  DepthRange range;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p(corner & 1 ? box.high.x() : box.low.x(), corner & 2 ? box.high.y() : box.low.y(),
                 corner & 4 ? box.high.z() : box.low.z());
    range.low = std::min(range.low, camera.distance(p));
    range.high = std::max(range.high, camera.distance(p));
  }
  return range;
}

PixelRect whole_picture(const Camera& camera) { return {0, 0, camera.width, camera.height}; }

}  // namespace

Result<LayerPass> LayerPass::create(const Gl& gl) {
  LayerPass pass(gl);
  if (auto status = pass.build(pass.plain_, ""); !status) return status.error();
  if (auto status = pass.build(pass.textured_, "#define TEXTURED\n"); !status) return status.error();
  return pass;
}

Status LayerPass::build(Program& program, const char* defines) {
  const std::string source = "#version 400 core\n" + std::string(defines) + std::string(shaders::layer_fragment);
  auto built = GlProgram::build(*gl_, shaders::layer_vertex, source);
  if (!built) return built.error();
  program.program = std::move(*built);
  const std::pair<GLint*, const char*> uniforms[] = {
      {&program.clip_from_model, "clip_from_model"}, {&program.camera_from_model, "camera_from_model"},
      {&program.room_from_camera, "room_from_camera"}, {&program.has_eye, "has_eye"},
      {&program.thing, "thing"}, {&program.least_alpha, "least_alpha"}};
  for (const auto& [uniform, name] : uniforms) *uniform = program.program.location(name);
  return {};
}

void LayerPass::reserve(int width, int height) {
  if (width <= width_ && height <= height_) return;
  width_ = std::max(width, width_);
  height_ = std::max(height, height_);
  surfaces_ = make_target_texture(*gl_, GL_RGBA32F, GL_RGBA, GL_FLOAT, width_, height_);
  numbers_ = make_target_texture(*gl_, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, width_, height_);
  depth_ = make_target_texture(*gl_, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, width_, height_);
  framebuffer_ = make_framebuffer(*gl_);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  const auto attach = [&](GLenum point, const GlName& texture) {
    gl_->FramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture.get(), 0);
  };
  attach(GL_COLOR_ATTACHMENT0, surfaces_);
  attach(GL_COLOR_ATTACHMENT1, numbers_);
  attach(GL_DEPTH_ATTACHMENT, depth_);
  constexpr GLenum buffers[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  gl_->DrawBuffers(2, buffers);
}

void LayerPass::draw(const std::vector<NumberedItem>& items, Layers& layers) {
  const Camera& camera = layers.camera;
  const auto pixels = static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
  layers.depths.resize(pixels);
  layers.normals.resize(pixels);
  layers.objects.resize(pixels);
  draw_tiles({items.data(), items.size()}, camera, whole_picture(camera), [&](const PixelRect& tile) {
    read_numbers(tile);
    read_surfaces(tile);
    std::size_t from = 0;
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x, ++from) {
        const auto to = static_cast<std::size_t>(y) * static_cast<std::size_t>(camera.width) +
                        static_cast<std::size_t>(x);
        layers.objects[to] = static_cast<std::uint16_t>(read_numbers_[from]);
        layers.normals[to] = read_surfaces_[from].head<3>();
        layers.depths[to] = read_surfaces_[from].w();
      }
  });
}

// Pixels of the item lie where its box does, and nothing hides it that begins behind the box.
std::size_t LayerPass::count(const NumberedItem& item, const std::vector<NumberedItem>& among, const Camera& camera) {
  const PixelRect part = covered_pixels(camera, item.item.box).clipped(whole_picture(camera));
  const double farthest = distances(camera, item.item.box).high;
  std::vector<NumberedItem> drawn;
  for (const auto& other : among)
    if (distances(camera, other.item.box).low <= farthest && covered_pixels(camera, other.item.box).meets(part))
      drawn.push_back(other);
  return count_in({drawn.data(), drawn.size()}, item, camera);
}

std::size_t LayerPass::count_alone(const NumberedItem& item, const Camera& camera) {
  return count_in({&item, 1}, item, camera);
}

std::size_t LayerPass::count_in(const Items& items, const NumberedItem& item, const Camera& camera) {
  std::size_t sum = 0;
  const PixelRect part = covered_pixels(camera, item.item.box).clipped(whole_picture(camera));
  draw_tiles(items, camera, part, [&](const PixelRect& tile) {
    read_numbers(tile);
    sum += static_cast<std::size_t>(std::count(read_numbers_.begin(), read_numbers_.end(), item.number));
  });
  return sum;
}

void LayerPass::draw_tiles(const Items& items, const Camera& camera, const PixelRect& part, const Read& read) {
  for (int y = part.y0; y < part.y1; y += layer_tile_side)
    for (int x = part.x0; x < part.x1; x += layer_tile_side) {
      const PixelRect tile = PixelRect{x, y, x + layer_tile_side, y + layer_tile_side}.clipped(part);
      reserve(tile.width(), tile.height());
      gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
      gl_->Viewport(-tile.x0, -tile.y0, camera.width, camera.height);
      gl_->Enable(GL_SCISSOR_TEST);
      gl_->Scissor(0, 0, tile.width(), tile.height());
      clear();
      paint(items, camera, tile);
      read(tile);
    }
}

void LayerPass::clear() const {
  constexpr float nothing[] = {0.0f, 0.0f, 0.0f, std::numeric_limits<float>::infinity()}, farthest[] = {1.0f};
  constexpr GLuint nobody[] = {0, 0, 0, 0};
  gl_->ClearBufferfv(GL_COLOR, 0, nothing);
  gl_->ClearBufferuiv(GL_COLOR, 1, nobody);
  gl_->ClearBufferfv(GL_DEPTH, 0, farthest);
}

void LayerPass::paint(const Items& items, const Camera& camera, const PixelRect& tile) const {
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(GL_LESS);
  gl_->ActiveTexture(GL_TEXTURE0);
  for (const auto* program : {&plain_, &textured_}) {
    program->program.use();
    const Eigen::Matrix3f turn = room_from_camera(camera).cast<float>();
    gl_->UniformMatrix3fv(program->room_from_camera, 1, GL_FALSE, turn.data());
    gl_->Uniform1i(program->has_eye, camera.eye ? 1 : 0);
    for (std::size_t k = 0; k < items.count; ++k) {
      if (!covered_pixels(camera, items.first[k].item.box).meets(tile)) continue;
      place(*program, items.first[k], camera);
      paint_batches(*program, items.first[k].item);
    }
  }
  gl_->Disable(GL_DEPTH_TEST);
}

void LayerPass::place(const Program& program, const NumberedItem& numbered, const Camera& camera) const {
  const Eigen::Matrix4d room_from_model = numbered.item.room_from_model();
  const Eigen::Matrix4f clip = (clip_from_room(camera) * room_from_model).cast<float>();
  const Eigen::Matrix4f seen = (camera_from_room(camera) * room_from_model).cast<float>();
  gl_->UniformMatrix4fv(program.clip_from_model, 1, GL_FALSE, clip.data());
  gl_->UniformMatrix4fv(program.camera_from_model, 1, GL_FALSE, seen.data());
  gl_->Uniform1ui(program.thing, numbered.number);
  numbered.item.model->bind(*gl_);
}

void LayerPass::paint_batches(const Program& program, const DrawItem& item) const {
  for (const auto& batch : item.model->batches()) {
    // Opaque texels need not be looked at.
    const bool textured = batch.texture && batch.alpha != AlphaMode::opaque;
    if (textured != (&program == &textured_)) continue;
    if (textured) gl_->BindTexture(GL_TEXTURE_2D, batch.texture);
    gl_->Uniform1f(program.least_alpha, least_alpha(batch.alpha));
    const auto offset = static_cast<std::size_t>(batch.first) * sizeof(std::uint32_t);
    gl_->DrawElements(GL_TRIANGLES, batch.count, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
  }
}

void LayerPass::read_numbers(const PixelRect& tile) {
  read_numbers_.resize(static_cast<std::size_t>(tile.width()) * static_cast<std::size_t>(tile.height()));
  gl_->PixelStorei(GL_PACK_ROW_LENGTH, 0);
  gl_->ReadBuffer(GL_COLOR_ATTACHMENT1);
  gl_->ReadPixels(0, 0, tile.width(), tile.height(), GL_RED_INTEGER, GL_UNSIGNED_INT, read_numbers_.data());
}

void LayerPass::read_surfaces(const PixelRect& tile) {
  read_surfaces_.resize(static_cast<std::size_t>(tile.width()) * static_cast<std::size_t>(tile.height()));
  gl_->PixelStorei(GL_PACK_ROW_LENGTH, 0);
  gl_->ReadBuffer(GL_COLOR_ATTACHMENT0);
  gl_->ReadPixels(0, 0, tile.width(), tile.height(), GL_RGBA, GL_FLOAT, read_surfaces_.data());
}

}  // namespace roomgen::detail
