#pragma once

#include <string>

#include "command.h"
#include "roomgen/base/json.h"
#include "roomgen/base/result.h"

namespace roomgen::cli {

/// What `check` does with a constraint program: its findings, then the program in words. Exit 1 on errors.
Result<int> check_program(const Context& context, const std::string& file, const Json& json);

}  // namespace roomgen::cli
