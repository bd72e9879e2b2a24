#pragma once

#include <nlohmann/json.hpp>

#include "roomgen/base/json.h"

namespace roomgen {

/// JSON that the program itself wrote: without mistakes.
Json json_literal(std::string_view text);

/// A member, or null where there is none or nothing that could have one.
inline const Json& member_of(const Json& value, std::string_view key) {
  static const Json nothing;
  if (!value.is_object()) return nothing;
  const auto found = value.find(key);
  return found == value.end() ? nothing : *found;
}

}  // namespace roomgen
