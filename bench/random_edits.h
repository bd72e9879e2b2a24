#pragma once

#include "base/random.h"
#include "roomgen/scene/scene.h"
#include "roomgen/edit/operation.h"

namespace roomgen::bench {

/// An edit that somebody might ask of this scene, whether or not there is room for it: things are brought,
/// taken out, moved to relations and to places, replaced, turned and made larger or smaller.
edit::Operation random_edit(const Scene& scene, Random& random);

/// "insertion", "removal", …
const char* sort_of(const edit::Operation& operation);

}  // namespace roomgen::bench
