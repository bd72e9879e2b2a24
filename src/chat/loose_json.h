#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"

namespace roomgen {

/// Longest answer that is read.
inline constexpr std::size_t max_reply_bytes = std::size_t{1} << 20;

struct LooseJson {
  Json json;                         ///< an object
  std::vector<std::string> repairs;  ///< what was not as it should be, one sentence each
};

/// Keys that tell the answer from other objects in the text: as they were asked for, and as they are
/// written besides.
struct WantedKeys {
  std::vector<std::string> names, spellings;
};

/// The JSON object in a language model's answer, among prose, code fences, thoughts and other
/// objects: the last whole one that has one of the wanted keys, also inside another one; else the
/// largest. What is nearly JSON is repaired. Errors tell the model what is missing.
Result<LooseJson> find_json(std::string_view text, const WantedKeys& wanted);

/// The member of an object under any of these names, whatever the case and the separators ("size
/// cm" finds "Size_CM"); null if there is none or its value is null.
const Json* member(const Json& object, const std::vector<std::string>& names);

/// The text of a value without blanks around it; empty of null, and of what is no text.
std::string text_in(const Json* value);

}  // namespace roomgen
