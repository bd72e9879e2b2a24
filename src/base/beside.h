#pragma once

#include <filesystem>

namespace roomgen::detail {

/// A name that nobody has, in the folder of `path`: ".NAME.HEX.part", the digits from the system's
/// randomness, so that it cannot be foreseen and runs at the same time do not meet.
std::filesystem::path name_beside(const std::filesystem::path& path);

/// Could name_beside(path) have given this name?
bool is_beside(const std::filesystem::path& path, const std::filesystem::path& name);

/// Could name_beside() have given this name to anything?
bool is_beside_something(const std::filesystem::path& name);

}  // namespace roomgen::detail
