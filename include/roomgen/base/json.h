#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "roomgen/base/result.h"

namespace roomgen {

/// Keeps the order of keys, so that files read as their authors wrote them and output is stable. Who looks
/// into one includes <nlohmann/json.hpp>.
using Json = nlohmann::ordered_json;

/// Parses UTF-8 JSON of at most 4,000,000 values, nested at most 64 deep (Error::Kind::limit). `source` names the text in
/// errors, which give line and column.
Result<Json> parse_json(std::string_view text, const std::string& source);

/// Indented by two, short arrays of plain values on one line, a newline at the end.
std::string dump_json(const Json& value);

/// On one line, without an end of line, whatever bytes the texts hold.
std::string json_line(const Json& value);

/// A number for a file: rounded to `decimals` places, so that output is short and stable.
double rounded(double value, int decimals = 4);

}  // namespace roomgen
