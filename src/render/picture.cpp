#include "picture.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "lit_shaders.h"
#include "shaders.h"

namespace roomgen::detail {

namespace {

constexpr int tile_side = 1024;
constexpr double occlusion_radius = 0.25;  // metres
constexpr double largest_radius = 80.0;    // pixels
constexpr int blur = 1;

// An eye sees what is near as large as can be.
double radius_in_pixels(const Camera& camera) {
  if (camera.eye) return largest_radius;
  return std::min(occlusion_radius * camera.pixels_per_metre, largest_radius);
}

PixelRect whole(const Camera& camera) {
  return {0, 0, camera.width, camera.height};
}

// Undoes the viewport: samples of a tile and depths in [0, 1] to clip coordinates of the picture.
Eigen::Matrix4d clip_from_pixel(const Camera& camera, const PixelRect& area) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.diagonal() << 1.0 / camera.width, 1.0 / camera.height, 2.0, 1.0;
  m.topRightCorner<3, 1>() << 2.0 * area.x0 / camera.width - 1.0,
      2.0 * area.y0 / camera.height - 1.0, -1.0;
  return m;
}

// Units of the maps that are lit.
constexpr GLint paint_unit = 0, facing_unit = 1, depth_unit = 2, glass_unit = 3, occlusion_unit = 4;

// Before the window it is bright.
constexpr float sky_background[3] = {0.94f, 0.97f, 0.995f};

// The box's corners as far as they lie before the near plane, and where its edges meet that plane.
std::vector<Vec3> corners_before(const Camera& camera, const Bounds3& box) {
  std::array<Vec3, 8> corners;
  for (std::size_t k = 0; k < corners.size(); ++k)
    corners[k] = {k & 1 ? box.high.x() : box.low.x(), k & 2 ? box.high.y() : box.low.y(), k & 4 ? box.high.z() : box.low.z()};
  if (!camera.eye) return {corners.begin(), corners.end()};
  std::vector<Vec3> before;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double beyond = camera.near - camera.depth(corners[k]);
    if (beyond >= 0) before.push_back(corners[k]);
    for (const std::size_t bit : {1u, 2u, 4u}) {
      const double other = camera.near - camera.depth(corners[k | bit]);
      if ((beyond < 0) != (other < 0))
        before.push_back(corners[k] + beyond / (beyond - other) * (corners[k | bit] - corners[k]));
    }
  }
  return before;
}

}  // namespace

PixelRect covered_pixels(const Camera& camera, const Bounds3& box) {
  const auto corners = corners_before(camera, box);
  if (corners.empty()) return {};
  Bounds2 extent;
  for (const Vec3& p : corners) extent.add(camera.pixel(p));
  return {pixel_at(extent.low.x()) - 1, pixel_at(extent.low.y()) - 1, pixel_at(extent.high.x()) + 2,
          pixel_at(extent.high.y()) + 2};
}

Picture::Picture(const Gl& gl)
    : gl_(&gl),
      light_programs_(gl, "", shaders::screen_vertex, shaders::light_fragment,
                      {{"paint_map", paint_unit},
                       {"facing_map", facing_unit},
                       {"depth_map", depth_unit},
                       {"glass_map", glass_unit},
                       {"occlusion_map", occlusion_unit}}) {}

Result<Picture> Picture::create(const Gl& gl) {
  Picture picture(gl);
  auto occlusion = GlProgram::build(gl, shaders::screen_vertex, shaders::occlusion_fragment);
  if (!occlusion) return occlusion.error();
  picture.occlusion_program_ = std::move(*occlusion);
  picture.screen_ = make_vertex_array(gl);
  return picture;
}

int Picture::reach(const Camera& camera) {
  return pixel_at(std::ceil(radius_in_pixels(camera))) + blur + 2;
}

void Picture::reserve(int width, int height) {
  if (width <= width_ && height <= height_) return;
  width_ = std::max(width, width_);
  height_ = std::max(height, height_);
  paint_ = make_target_texture(*gl_, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 2 * width_, 2 * height_);
  facing_ = make_target_texture(*gl_, GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, 2 * width_, 2 * height_);
  glass_ = make_target_texture(*gl_, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 2 * width_, 2 * height_);
  depth_ = make_target_texture(*gl_, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT,
                               2 * width_, 2 * height_);
  occlusion_ = make_target_texture(*gl_, GL_RG32F, GL_RG, GL_FLOAT, width_, height_);
  result_ = make_target_texture(*gl_, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, width_, height_);
  const auto attach = [&](GLenum point, const GlName& texture) {
    gl_->FramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture.get(), 0);
  };
  const auto begin = [&](GlName& framebuffer, const GlName& texture) {
    framebuffer = make_framebuffer(*gl_);
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
    attach(GL_COLOR_ATTACHMENT0, texture);
  };
  begin(surface_buffer_, paint_);
  attach(GL_COLOR_ATTACHMENT1, facing_);
  attach(GL_DEPTH_ATTACHMENT, depth_);
  constexpr GLenum buffers[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  gl_->DrawBuffers(2, buffers);
  begin(glass_buffer_, glass_);
  attach(GL_DEPTH_ATTACHMENT, depth_);
  begin(occlusion_buffer_, occlusion_);
  begin(result_buffer_, result_);
}

Status Picture::draw(ScenePainter& painter, const DrawList& items, const Camera& camera,
                     const SceneLight& light, const PixelRect& part, bool continued, Image& image) {
  const int margin = reach(camera);
  // Ambient occlusion looks at depths around; those of a picture in one piece are still there.
  const bool one_tile = std::max(camera.width, camera.height) <= tile_side;
  const int redrawn_margin = continued && one_tile ? 0 : margin;
  for (int y = 0; y < camera.height; y += tile_side)
    for (int x = 0; x < camera.width; x += tile_side) {
      const PixelRect square = PixelRect{x, y, x + tile_side, y + tile_side}.clipped(whole(camera));
      Tile tile;
      tile.wanted = square.clipped(part);
      if (tile.wanted.empty()) continue;
      tile.area = square.grown(margin).clipped(whole(camera));
      tile.painted = tile.wanted.grown(redrawn_margin).clipped(tile.area);
      reserve(tile.area.width(), tile.area.height());
      const Sight sight(camera, light, clip_from_pixel(camera, tile.area));
      if (auto status = paint(painter, items, sight, tile); !status) return status;
      add_occlusion(camera, tile);
      if (auto status = this->light(sight, tile, image); !status) return status;
    }
  return {};
}

void Picture::set_scissor(const PixelRect& part, const PixelRect& area, int scale) const {
  gl_->Enable(GL_SCISSOR_TEST);
  gl_->Scissor(scale * (part.x0 - area.x0), scale * (part.y0 - area.y0), scale * part.width(),
               scale * part.height());
}

Status Picture::paint(ScenePainter& painter, const DrawList& items, const Sight& sight, const Tile& tile) {
  const Camera& camera = *sight.camera;
  const auto visible = [&](const DrawItem& item) { return covered_pixels(camera, item.box).meets(tile.painted); };
  constexpr float nothing[] = {0.0f, 0.0f, 0.0f, 0.0f}, farthest[] = {1.0f};
  gl_->BindFramebuffer(GL_FRAMEBUFFER, surface_buffer_.get());
  gl_->Viewport(-2 * tile.area.x0, -2 * tile.area.y0, 2 * camera.width, 2 * camera.height);
  set_scissor(tile.painted, tile.area, 2);
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(GL_LESS);
  gl_->ClearBufferfv(GL_COLOR, 0, nothing);
  gl_->ClearBufferfv(GL_COLOR, 1, nothing);
  gl_->ClearBufferfv(GL_DEPTH, 0, farthest);
  painter.paint_surfaces(items, sight, visible);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, glass_buffer_.get());
  gl_->ClearBufferfv(GL_COLOR, 0, nothing);
  auto status = painter.paint_glass(items, sight, visible);
  gl_->Disable(GL_DEPTH_TEST);
  return status;
}

void Picture::add_occlusion(const Camera& camera, const Tile& tile) {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, occlusion_buffer_.get());
  gl_->Viewport(0, 0, tile.area.width(), tile.area.height());
  set_scissor(tile.wanted.grown(blur).clipped(tile.area), tile.area, 1);
  const GlProgram& program = occlusion_program_;
  program.use();
  gl_->ActiveTexture(GL_TEXTURE0);
  gl_->BindTexture(GL_TEXTURE_2D, depth_.get());
  set_depths(program, camera, tile);
  gl_->Uniform2i(program.location("origin"), tile.area.x0, tile.area.y0);
  gl_->Uniform2i(program.location("limit"), tile.area.width(), tile.area.height());
  gl_->BindVertexArray(screen_.get());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

// How the occlusion's shader finds places from depths.
void Picture::set_depths(const GlProgram& program, const Camera& camera, const Tile& tile) const {
  const auto set4 = [&](double x, double y, double z, double w) {
    gl_->Uniform4f(program.location("metres"), static_cast<float>(x), static_cast<float>(y),
                   static_cast<float>(z), static_cast<float>(w));
  };
  const auto set2 = [&](const char* name, double x, double y) {
    gl_->Uniform2f(program.location(name), static_cast<float>(x), static_cast<float>(y));
  };
  const double pixel = 1.0 / camera.pixels_per_metre;
  if (camera.eye) {
    const auto [near, far] = planes(camera);
    set4(0.0, far * near, near - far, far);
    set2("scale", 0.0, pixel);
    set2("middle", 0.5 * camera.width - camera.center.x() / pixel - tile.area.x0,
         0.5 * camera.height + camera.center.y() / pixel - tile.area.y0);
  } else {
    set4(camera.near - camera.far, 0.0, 0.0, 1.0);
    set2("scale", pixel, 0.0);
    set2("middle", 0.0, 0.0);
  }
  set2("radius", occlusion_radius, largest_radius);
}

void Picture::bind(GLint unit, const GlName& texture) const {
  gl_->ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl_->BindTexture(GL_TEXTURE_2D, texture.get());
}

Status Picture::light(const Sight& sight, const Tile& tile, Image& image) {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, result_buffer_.get());
  gl_->Viewport(0, 0, tile.area.width(), tile.area.height());
  set_scissor(tile.wanted, tile.area, 1);
  const auto program = light_programs_.of(sight);
  if (!program) return program.error();
  (*program)->use(sight);
  const auto& background = sight.camera->eye ? sky_background : paper_background;
  gl_->Uniform3f((*program)->location("background"), background[0], background[1], background[2]);
  gl_->Uniform2i((*program)->location("limit"), tile.area.width(), tile.area.height());
  bind(occlusion_unit, occlusion_);
  bind(glass_unit, glass_);
  bind(depth_unit, depth_);
  bind(facing_unit, facing_);
  bind(paint_unit, paint_);
  gl_->BindVertexArray(screen_.get());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  gl_->PixelStorei(GL_PACK_ROW_LENGTH, image.width);
  gl_->ReadPixels(tile.wanted.x0 - tile.area.x0, tile.wanted.y0 - tile.area.y0, tile.wanted.width(),
                  tile.wanted.height(), GL_RGBA, GL_UNSIGNED_BYTE,
                  image.at(tile.wanted.x0, tile.wanted.y0));
  return {};
}

}  // namespace roomgen::detail
