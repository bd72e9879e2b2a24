#include "shadow_map.h"

#include <Eigen/Geometry>

namespace roomgen::detail {

ShadowMap::ShadowMap(const Gl& gl) : gl_(&gl) {
  depth_ = make_target_texture(gl, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, size, size);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  // What lies beyond the map is in the sun.
  const float lit[4] = {1.0f, 1.0f, 1.0f, 1.0f};
  gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, lit);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  framebuffer_ = make_framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.get(), 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
}

PixelRect ShadowMap::covered_by(const Sun& sun, const Bounds3& box) {
  Bounds2 extent;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p(corner & 1 ? box.high.x() : box.low.x(), corner & 2 ? box.high.y() : box.low.y(),
                 corner & 4 ? box.high.z() : box.low.z());
    extent.add((sun.clip_from_room * p.homogeneous()).head<2>());
  }
  const auto pixel = [](double clip) {
    return pixel_at((0.5 * clip + 0.5) * size);
  };
  return PixelRect{pixel(extent.low.x()), pixel(extent.low.y()), pixel(extent.high.x()) + 1,
                   pixel(extent.high.y()) + 1}
      .grown(1)
      .clipped(whole());
}

void ShadowMap::update(const ScenePainter& painter, const DrawList& items, const Sun& sun,
                       const PixelRect& part) {
  if (part.empty()) return;
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  gl_->Viewport(0, 0, size, size);
  gl_->Enable(GL_DEPTH_TEST);
  gl_->Enable(GL_SCISSOR_TEST);
  gl_->Scissor(part.x0, part.y0, part.width(), part.height());
  gl_->Clear(GL_DEPTH_BUFFER_BIT);
  gl_->Enable(GL_POLYGON_OFFSET_FILL);
  // Against surfaces that shadow themselves; the constant part is 12 mm.
  gl_->PolygonOffset(3.5f, static_cast<float>(0.012 / sun.depth * 16777216.0));
  painter.paint_shadows(items, sun.clip_from_room, [&](const DrawItem& item) {
    return covered_by(sun, item.box).meets(part);
  });
  gl_->Disable(GL_POLYGON_OFFSET_FILL);
  gl_->Disable(GL_DEPTH_TEST);
}

}  // namespace roomgen::detail
