#pragma once

#include <string>
#include <vector>

#include "roomgen/lab/questions.h"

namespace roomgen::cli {

/// questions.jsonl
std::string question_lines(const std::vector<lab::SpatialQuestion>& questions);

}  // namespace roomgen::cli
