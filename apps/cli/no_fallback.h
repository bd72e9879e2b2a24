#pragma once

#include <memory>

#include "roomgen/design/designer.h"

namespace roomgen::cli {

/// Takes over from a model by saying that nobody does: no plan is an error, and the room ends where the model does.
std::unique_ptr<Designer> make_no_fallback();

}  // namespace roomgen::cli
