#pragma once

#include <string>
#include <vector>

#include "designers.h"
#include "roomgen/base/json.h"
#include "roomgen/generate/generate.h"

namespace roomgen::cli {

/// What a model took for a room, and what rules did instead of it: lines to print, and the same for
/// scripts. Calls, tokens and money are those of every request that the endpoint got; for a replay,
/// which asks nobody, they are what the answers took when they were recorded.
std::vector<std::string> bill_lines(const ComposedDesigner& composed, const Generation& generation);
Json bill_json(const ComposedDesigner& composed, const Generation& generation);

/// An error with what the model took all the same, if it took anything.
Error with_bill(const Error& error, const ComposedDesigner& composed);

}  // namespace roomgen::cli
