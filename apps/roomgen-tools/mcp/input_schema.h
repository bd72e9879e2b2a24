#pragma once

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"

namespace roomgen::mcp {

/// Does a value keep to a schema? The same text that clients are given decides what is taken. Of JSON Schema the
/// words that data/mcp/tools.json uses: type, enum, properties, required, additionalProperties, items,
/// minimum, maximum, minLength, maxLength, minItems, maxItems. The error names the place: "/seed: …".
Status check_input(const Json& schema, const Json& value);

}  // namespace roomgen::mcp
