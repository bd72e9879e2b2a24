#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "roomgen/base/json.h"

namespace roomgen {

/// JSON that the program itself wrote: without mistakes.
Json json_literal(std::string_view text);

}  // namespace roomgen
