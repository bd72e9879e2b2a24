#pragma once

#include <array>
#include <memory>

#include "gl.h"
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
  explicit GlContext(void* handle) : handle_(handle) {}
  Status load_functions();

  void* handle_;  ///< OSMesaContext
  std::array<unsigned char, 4 * 4 * 4> buffer_{};
  Gl gl_;
};

}  // namespace roomgen::detail
