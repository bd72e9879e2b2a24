#include "gl_context.h"

namespace roomgen::detail {

namespace {

Error unavailable(const std::string& what) {
  return {Error::Kind::unavailable, "OSMesa: " + what};
}

std::mutex& turns() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

GlTurn::GlTurn() : lock_(turns()) {}

GlTurn::~GlTurn() {
  if (const auto& mesa = osmesa()) mesa->MakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
}

Result<std::unique_ptr<GlContext>> GlContext::create() {
  const auto& mesa = osmesa();
  if (!mesa) return mesa.error();
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            0,
                            OSMESA_STENCIL_BITS,
                            0,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            4,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            0,
                            0};
  const OSMesaContext handle = mesa->CreateContextAttribs(attributes, nullptr);
  if (!handle) return unavailable("no OpenGL 4.0 core context; Mesa 20.2 or newer is needed");
  std::unique_ptr<GlContext> context(new GlContext(*mesa, handle));
  if (auto status = context->make_current(); !status) return status.error();
  if (auto status = context->load_functions(); !status) return status.error();
  return context;
}

GlContext::~GlContext() {
  mesa_.DestroyContext(handle_);
}

Status GlContext::make_current() {
  if (!mesa_.MakeCurrent(handle_, buffer_.data(), GL_UNSIGNED_BYTE, 4, 4))
    return unavailable("the context cannot be made current");
  return {};
}

Status GlContext::load_functions() {
#define ROOMGEN_LOAD(name)                                                              \
  gl_.name = reinterpret_cast<decltype(gl_.name)>(mesa_.GetProcAddress("gl" #name)); \
  if (!gl_.name) return unavailable("lacks gl" #name);
  ROOMGEN_GL_FUNCTIONS(ROOMGEN_LOAD)
#undef ROOMGEN_LOAD
  return {};
}

}  // namespace roomgen::detail
