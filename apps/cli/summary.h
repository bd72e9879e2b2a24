#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "any_plan.h"
#include "roomgen/generate/generate.h"

namespace roomgen::cli {

/// What became of a plan, for scripts.
Json summary_json(const std::filesystem::path& folder, const Generation& generation);

/// "6 of 9 things you asked for, and 2 of 3 that people and activities need; a bedroom with 14 objects"
std::string headline(const Scene& scene);
/// What was assumed and what stands in for something else.
std::vector<std::string> note_lines(const AnyPlan& plan, const Generation& generation);
/// What the prompt asked for and the room does not have, what of it nobody understood, and what was left out.
std::vector<std::string> lack_lines(const Scene& scene);

/// Everything has its place, and nothing that was asked for is missing, doubtful or not understood.
bool is_as_asked(const Scene& scene);

}  // namespace roomgen::cli
