#pragma once

#include <string_view>
#include <utility>

#include "gl.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"

namespace roomgen::detail {

// Owners of OpenGL names: freed with their owner, who must not outlive the context.

/// A name and the function that frees it.
class GlName {
 public:
  using Free = void (*)(const Gl&, GLuint);

  GlName() = default;
  GlName(const Gl& gl, GLuint name, Free free) : gl_(&gl), name_(name), free_(free) {}
  ~GlName() { reset(); }
  GlName(GlName&& other) noexcept { *this = std::move(other); }
  GlName& operator=(GlName&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(name_, other.name_);
    std::swap(free_, other.free_);
    return *this;
  }

  GLuint get() const { return name_; }

 private:
  void reset() {
    if (name_) free_(*gl_, name_);
    name_ = 0;
  }

  const Gl* gl_ = nullptr;
  GLuint name_ = 0;
  Free free_ = nullptr;
};

GlName make_buffer(const Gl& gl);
GlName make_vertex_array(const Gl& gl);
GlName make_framebuffer(const Gl& gl);
/// An empty texture, clamped to its edge and without mipmaps.
GlName make_target_texture(const Gl& gl, GLint internal_format, GLenum format, GLenum type,
                           int width, int height);
/// A repeating texture with mipmaps.
GlName make_image_texture(const Gl& gl, const Image& image);

/// A linked program; uniforms by name. Building one fails only if this code is wrong for the
/// driver.
class GlProgram {
 public:
  GlProgram() = default;
  static Result<GlProgram> build(const Gl& gl, std::string_view vertex, std::string_view fragment);

  void use() const { gl_->UseProgram(name_.get()); }
  GLint location(const char* uniform) const {
    return gl_->GetUniformLocation(name_.get(), uniform);
  }

 private:
  const Gl* gl_ = nullptr;
  GlName name_;
};

}  // namespace roomgen::detail
