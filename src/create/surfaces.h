#pragma once

#include "roomgen/shape/evaluate.h"

namespace roomgen::create {

/// The same surfaces, a body for each that is closed by itself: a body that was joined of several,
/// or that a model wrote as one, may be several things that do not touch.
shape::Shape separate_surfaces(const shape::Shape& shape);

}  // namespace roomgen::create
