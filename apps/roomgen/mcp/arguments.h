#pragma once

#include "any_plan.h"
#include "workplace.h"

namespace roomgen::mcp {

/// prompt, seed, size and floor_plan.
Result<cli::PlanWish> plan_wish(const Workplace& place, const Json& arguments);

/// Where a file may be written: below the root, of this ending, and neither a room's own file nor, if it is there,
/// one of another kind. The folder is made.
Result<std::filesystem::path> new_file(const Workplace& place, const std::string& path, const std::string& ending);

}  // namespace roomgen::mcp
