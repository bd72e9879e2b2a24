#pragma once

#include <string>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"

namespace roomgen::mcp {

/// Does a value keep to a schema? The same text that clients are given decides what is taken. Of JSON Schema the
/// words that data/mcp/tools.json uses: type, enum, properties, required, additionalProperties, items,
/// minimum, maximum, minLength, maxLength, minItems, maxItems. The error names the place: "/seed: …".
/// What it refuses it says the wanted form of: "expected a list of numbers, as in [1.5, 2]".
Status check_input(const Json& schema, const Json& value);

/// Of a type of JSON Schema: object, array, string, boolean, integer, number.
bool is_of_type(const Json& value, const std::string& type);

}  // namespace roomgen::mcp
