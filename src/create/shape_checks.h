#pragma once

#include "roomgen/base/result.h"
#include "roomgen/shape/evaluate.h"

namespace roomgen::create {

/// Is it as large as things in rooms are? The error says how large it is.
Status check_extent(const shape::Shape& shape);

}  // namespace roomgen::create
