#pragma once

#include "any_plan.h"
#include "workplace.h"

namespace roomgen::mcp {

/// prompt, seed, size and floor_plan.
Result<cli::PlanWish> plan_wish(const Workplace& place, const Json& arguments);

/// "folder", below the root, in which there is no room yet unless "replace" says so.
Result<std::filesystem::path> new_room_folder(const Workplace& place, const Json& arguments);

/// What of a room's prompt nobody understood.
std::vector<std::string> not_understood(const Scene& scene);

/// Where a file may be written: below the root, of this ending, and neither a room's own file nor, if it is there,
/// one of another kind. The folder is made.
Result<std::filesystem::path> new_file(const Workplace& place, const std::string& path, const std::string& ending);

}  // namespace roomgen::mcp
