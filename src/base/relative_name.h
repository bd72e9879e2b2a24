#pragma once

#include <string_view>

namespace roomgen {

/// Does a name in a stranger's file stay below the folder that it is relative to? With forward slashes, without
/// "..", a drive or control characters.
bool stays_below(std::string_view name);

}  // namespace roomgen
