#pragma once

#include <vector>

#include "roomgen/scene/scene.h"
#include "roomgen/scene/object.h"

namespace roomgen {

/// Where the mesh of a placed thing comes lower than `height` above the floor: the feet of a table, all of
/// a chest. Rectangles that together cover those parts from above, one for what hangs together; each is
/// square to the thing. None if nothing of it comes so low.
std::vector<Footprint> low_parts(const Object& object, const ModelTable& models, double height);

}  // namespace roomgen
