#pragma once

#include <filesystem>
#include <string>

#include "roomgen/base/result.h"

namespace roomgen::cli {

/// A file that belongs to the program: beside it in a build tree, in the library folder of its installation
/// otherwise. Found by the program's own place, so that neither a path of the machine that built it nor the working
/// folder decides what is loaded or run. `why` ends the message when it is missing.
Result<std::filesystem::path> find_beside_program(const std::string& name, const std::string& why);

}  // namespace roomgen::cli
