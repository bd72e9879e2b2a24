#pragma once

#include "roomgen/base/json.h"

namespace roomgen::mcp {

/// data/mcp/tools.json, which is compiled in.
Json about();

}  // namespace roomgen::mcp
