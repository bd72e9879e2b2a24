#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "roomgen/base/json.h"

namespace roomgen::create {

/// Mends what is clear in an answer that should be a shape program: the head, keys and names that
/// were nearly right, solids written beside their type, materials that are colours, connections to
/// nothing. The rest is left to the reader of programs, whose error tells the model.
void repair_program(Json& program, std::vector<std::string>& repairs);

}  // namespace roomgen::create
