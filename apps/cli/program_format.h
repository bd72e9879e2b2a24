#pragma once

#include <nlohmann/json.hpp>

#include "roomgen/base/json.h"

namespace roomgen::cli {

/// Is the document a constraint program (docs/programs.md)? The laboratory reads those.
inline bool is_constraint_program(const Json& json) {
  if (!json.is_object()) return false;
  const auto format = json.find("format");
  if (format != json.end()) return *format == "roomgen-program";
  return json.contains("constraints") && json.contains("sets");
}

}  // namespace roomgen::cli
