#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "roomgen/base/json.h"

namespace roomgen {

/// An answer about one object that was given without any JSON, as the object that it stands for:
/// the last line that is a list of constraints ("edge | near, bed-0") and the last point in
/// brackets
/// ("[1.2, 3.4]"). Nothing if it holds no such line.
std::optional<Json> read_plain_reply(std::string_view text);

}  // namespace roomgen
