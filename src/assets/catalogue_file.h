#pragma once

#include <filesystem>
#include <string>

#include "roomgen/base/result.h"

namespace roomgen::assets {

/// Where the catalogue of a library is kept: a file of its own for each library and for each state of what
/// this program knows of furniture, so that two versions of the program do not take it from each other.
std::filesystem::path catalogue_path(const std::filesystem::path& library, const std::filesystem::path& cache_dir);

/// What a catalogue is made from: changes when a file of the library does, or what this program knows.
Result<std::string> stamp_of(const std::filesystem::path& library);

/// Writes a hash of the catalogue beside it, which tells later whether its bytes are still those that were
/// written.
Status seal(const std::filesystem::path& catalogue);
bool is_sealed(const std::filesystem::path& catalogue);
bool is_whole(const std::filesystem::path& catalogue);

/// Removes catalogues of the same library that other versions made, but for the newest few.
void drop_older(const std::filesystem::path& catalogue);

}  // namespace roomgen::assets
