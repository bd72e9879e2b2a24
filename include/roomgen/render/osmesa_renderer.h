#pragma once

#include <memory>

#include "roomgen/base/result.h"
#include "roomgen/view/view.h"

namespace roomgen {

/// Draws with OpenGL in main memory (OSMesa): no window, display or graphics card is needed.
///
/// A renderer keeps the meshes, textures and last pictures it has seen, so that the next picture of
/// a room draws only what changed. One thread at a time may use it; several renderers may work side
/// by side. Fails with Error::Kind::unavailable when OSMesa gives no OpenGL 4.0 core context.
Result<std::unique_ptr<Renderer>> make_osmesa_renderer();

}  // namespace roomgen
