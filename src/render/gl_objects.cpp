#include "gl_objects.h"

#include <string>

namespace roomgen::detail {

namespace {

Error shader_error(const std::string& log) {
  return {Error::Kind::unavailable, "OpenGL does not accept a shader: " + log};
}

Result<GlName> compile(const Gl& gl, GLenum stage, std::string_view source) {
  GlName shader(gl, gl.CreateShader(stage), [](const Gl& g, GLuint n) { g.DeleteShader(n); });
  const char* text = source.data();
  const auto length = static_cast<GLint>(source.size());
  gl.ShaderSource(shader.get(), 1, &text, &length);
  gl.CompileShader(shader.get());
  GLint ok = 0;
  gl.GetShaderiv(shader.get(), GL_COMPILE_STATUS, &ok);
  if (ok) return shader;
  char log[1024] = "";
  gl.GetShaderInfoLog(shader.get(), sizeof log, nullptr, log);
  return shader_error(log);
}

void set_filter(const Gl& gl, GLint minify, GLint magnify, GLint wrap) {
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minify);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magnify);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
}

GlName make_texture(const Gl& gl) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  return {gl, name, [](const Gl& g, GLuint n) { g.DeleteTextures(1, &n); }};
}

}  // namespace

GlName make_buffer(const Gl& gl) {
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  return {gl, name, [](const Gl& g, GLuint n) { g.DeleteBuffers(1, &n); }};
}

GlName make_vertex_array(const Gl& gl) {
  GLuint name = 0;
  gl.GenVertexArrays(1, &name);
  return {gl, name, [](const Gl& g, GLuint n) { g.DeleteVertexArrays(1, &n); }};
}

GlName make_framebuffer(const Gl& gl) {
  GLuint name = 0;
  gl.GenFramebuffers(1, &name);
  return {gl, name, [](const Gl& g, GLuint n) { g.DeleteFramebuffers(1, &n); }};
}

GlName make_target_texture(const Gl& gl, GLint internal_format, GLenum format, GLenum type,
                           int width, int height) {
  GlName texture = make_texture(gl);
  gl.TexImage2D(GL_TEXTURE_2D, 0, internal_format, width, height, 0, format, type, nullptr);
  set_filter(gl, GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE);
  return texture;
}

GlName make_image_texture(const Gl& gl, const Image& image) {
  GlName texture = make_texture(gl);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                image.pixels.data());
  set_filter(gl, GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, GL_REPEAT);
  gl.GenerateMipmap(GL_TEXTURE_2D);
  return texture;
}

Result<GlProgram> GlProgram::build(const Gl& gl, std::string_view vertex,
                                   std::string_view fragment) {
  auto vertex_shader = compile(gl, GL_VERTEX_SHADER, vertex);
  if (!vertex_shader) return vertex_shader.error();
  auto fragment_shader = compile(gl, GL_FRAGMENT_SHADER, fragment);
  if (!fragment_shader) return fragment_shader.error();
  GlProgram program;
  program.gl_ = &gl;
  program.name_ = {gl, gl.CreateProgram(), [](const Gl& g, GLuint n) { g.DeleteProgram(n); }};
  gl.AttachShader(program.name_.get(), vertex_shader->get());
  gl.AttachShader(program.name_.get(), fragment_shader->get());
  gl.LinkProgram(program.name_.get());
  GLint ok = 0;
  gl.GetProgramiv(program.name_.get(), GL_LINK_STATUS, &ok);
  if (ok) return program;
  char log[1024] = "";
  gl.GetProgramInfoLog(program.name_.get(), sizeof log, nullptr, log);
  return shader_error(log);
}

}  // namespace roomgen::detail
