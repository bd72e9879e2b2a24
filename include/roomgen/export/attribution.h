#pragma once

#include <string>

#include "roomgen/scene/scene.h"

namespace roomgen {

/// ATTRIBUTION.md for a scene: every asset of a library once, with creator, licence and the objects,
/// doors and windows that use it. Things that roomgen made itself need none.
std::string attribution_markdown(const Scene& scene);

/// The same in one line, for files that have a field for it; empty if nothing needs it.
std::string attribution_line(const Scene& scene);

}  // namespace roomgen
