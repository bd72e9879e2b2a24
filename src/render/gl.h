#pragma once

// The only header of the project that sees OpenGL. Functions are looked up by name at run time, so
// that nothing but OSMesa is linked.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

namespace roomgen::detail {

#define ROOMGEN_GL_FUNCTIONS(X)                                                                    \
  X(ActiveTexture) X(AttachShader) X(BindBuffer) X(BindFramebuffer) X(BindTexture)                 \
  X(BindVertexArray) X(BlendFuncSeparate) X(BufferData) X(CheckFramebufferStatus) X(Clear)         \
  X(ClearBufferfv) X(ClearBufferuiv) X(ClearColor) X(ColorMask) X(CompileShader) X(CreateProgram)  \
  X(CreateShader) X(DeleteBuffers) X(DeleteFramebuffers) X(DeleteProgram) X(DeleteShader)          \
  X(DeleteTextures) X(DeleteVertexArrays) X(DepthFunc) X(DepthMask) X(Disable) X(DrawArrays)       \
  X(DrawBuffer) X(DrawBuffers) X(DrawElements) X(Enable) X(EnableVertexAttribArray)                \
  X(FramebufferTexture2D) X(GenBuffers) X(GenFramebuffers) X(GenTextures) X(GenVertexArrays)       \
  X(GenerateMipmap) X(GetError) X(GetIntegerv) X(GetProgramInfoLog) X(GetProgramiv)                \
  X(GetShaderInfoLog) X(GetShaderiv) X(GetUniformLocation) X(LinkProgram) X(PixelStorei)           \
  X(PolygonOffset) X(ReadBuffer) X(ReadPixels) X(Scissor) X(ShaderSource) X(TexImage2D)            \
  X(TexParameterfv) X(TexParameteri) X(Uniform1f) X(Uniform1i) X(Uniform1ui) X(Uniform2f)          \
  X(Uniform2i) X(Uniform3f) X(Uniform3fv) X(Uniform4f) X(Uniform4fv) X(UniformMatrix3fv)           \
  X(UniformMatrix4fv) X(UseProgram) X(VertexAttribPointer) X(Viewport)

/// OpenGL entry points: gl.DrawElements(…).
struct Gl {
#define ROOMGEN_DECLARE(name) decltype(&::gl##name) name = nullptr;
  ROOMGEN_GL_FUNCTIONS(ROOMGEN_DECLARE)
#undef ROOMGEN_DECLARE
};

}  // namespace roomgen::detail
