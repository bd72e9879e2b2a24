#pragma once

#include <array>
#include <memory>
#include <mutex>

#include "gl.h"
#include "osmesa.h"
#include "roomgen/base/result.h"

namespace roomgen::detail {

/// The turn of a thread at OpenGL, for as long as this lives; others wait for theirs. Contexts of one process are not
/// apart in Mesa: whenever one of them fills, reads or maps a texture, llvmpipe looks through what all others have still
/// to draw (llvmpipe_flush_resource), without a lock against who draws there (seen in 22.3); and much is set up with
/// the first shader and without a lock. It draws with several threads itself. All that is done with a context, from its
/// creation to its end, is done in a turn, and not in a turn within a turn.
class GlTurn {
 public:
  GlTurn();
  /// No context stays current, which another thread could use or destroy next.
  ~GlTurn();
  GlTurn(const GlTurn&) = delete;
  GlTurn& operator=(const GlTurn&) = delete;

 private:
  std::unique_lock<std::mutex> lock_;
};

/// An OpenGL 4.0 core context in main memory. Pictures are drawn into framebuffer objects; the
/// context's own buffer is a formality. Everything here needs a GlTurn.
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
