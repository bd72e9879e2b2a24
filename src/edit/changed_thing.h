#pragma once

#include "draft.h"

namespace roomgen {

/// The thing with another width, depth and height, if such things may be so.
Result<Object> with_size(const Draft& draft, Object object, const Vec3& size);

/// A thing that is another one now (its mesh, its size) at its place, or a little aside; with all that stood on it
/// (`before`), as near as can be to where it did. The order of the scene's objects stays.
Status put_changed(Draft& draft, const Cluster& before, Object changed);

}  // namespace roomgen
