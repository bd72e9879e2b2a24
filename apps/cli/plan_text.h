#pragma once

#include <string>
#include <vector>

#include "any_plan.h"

namespace roomgen::cli {

/// What people are told of a plan, a line each.
std::vector<std::string> plan_lines(const AnyPlan& plan);
/// The prompt in pieces, each with what it was taken for and what checks it.
std::vector<std::string> heard_lines(const AnyPlan& plan);

}  // namespace roomgen::cli
