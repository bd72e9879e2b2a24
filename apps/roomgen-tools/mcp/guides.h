#pragma once

#include <optional>
#include <string>

#include "roomgen/base/json.h"

/// What agents read before they design, as resources: roomgen:///docs/skill.md and others.
namespace roomgen::mcp {

Json list_guides();
/// Nothing for an address that is none of them.
std::optional<std::string> read_guide(const std::string& uri);

}  // namespace roomgen::mcp
