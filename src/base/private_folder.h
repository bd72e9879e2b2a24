#pragma once

#include <filesystem>
#include <string>

#include "roomgen/base/result.h"

namespace roomgen {

/// May files be made in this folder, or in the nearest one above it that is there?
bool may_write_below(const std::filesystem::path& folder);

/// A folder below the system's temporary one that nobody else can write: the same one each time for a user
/// ("roomgen-1000"), a new one where that name is taken by anything else.
Result<std::filesystem::path> private_folder(const std::string& name);

}  // namespace roomgen
