#pragma once

#include <array>
#include <memory>

#include "gl.h"
#include "osmesa.h"
#include "roomgen/base/result.h"

namespace roomgen::detail {

/// An OpenGL 4.0 core context in main memory. Pictures are drawn into framebuffer objects; the
/// context's own buffer is a formality.
class GlContext {
 public:
  static Result<std::unique_ptr<GlContext>> create();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Contexts are current for a thread: to be called before any drawing.
  Status make_current();
  const Gl& gl() const { return gl_; }

 private:
  GlContext(const OsMesa& mesa, OSMesaContext handle) : mesa_(mesa), handle_(handle) {}
  Status load_functions();

  OsMesa mesa_;
  OSMesaContext handle_;
  std::array<unsigned char, 4 * 4 * 4> buffer_{};
  Gl gl_;
};

}  // namespace roomgen::detail
