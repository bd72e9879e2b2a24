#pragma once

#include <string>
#include <vector>

#include "roomgen/questions/questions.h"

namespace roomgen::cli {

/// questions.jsonl
std::string question_lines(const std::vector<SpatialQuestion>& questions);

}  // namespace roomgen::cli
