#pragma once

#include <filesystem>

#include "roomgen/base/result.h"

namespace roomgen::decode {

/// Where roomgen-decode is: what the environment variable ROOMGEN_DECODER names, else beside the running
/// program, in the library folder of its installation, or where this library was installed or built.
Result<std::filesystem::path> find_decoder();

}  // namespace roomgen::decode
