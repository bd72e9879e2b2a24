#pragma once

#include <map>
#include <string>
#include <string_view>

#include "roomgen/base/result.h"

namespace roomgen::assets {

/// The key-value pairs of a Java .properties text (ISO-8859-1, \uXXXX escapes, lines continued by a
/// final backslash), as UTF-8. Lines without a value read as "". At most two million.
Result<std::map<std::string, std::string, std::less<>>> parse_properties(std::string_view latin1);

}  // namespace roomgen::assets
