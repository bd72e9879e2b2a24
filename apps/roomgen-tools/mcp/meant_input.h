#pragma once

#include "roomgen/base/json.h"

namespace roomgen::mcp {

/// What a client means by a value of this schema. Clients in strict mode send all properties, and
/// models write numbers and lists as texts, so:
/// - members that the schema knows and that are null, "" or [] are left out;
/// - where it wants a number, true or false, a list or an object, a text of one is read: "4.5",
///   "True", "[1, 2]", and "1, 2" for a list of numbers;
/// - 7.0 is the whole number 7.
/// What cannot be read stays as it was given, for check_input to refuse.
Json as_meant(const Json& schema, const Json& value);

}  // namespace roomgen::mcp
