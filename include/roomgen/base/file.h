#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "roomgen/base/result.h"

namespace roomgen {

/// Largest JSON document that is read (problems, plans, scenes).
inline constexpr std::size_t max_document_bytes = 64u << 20;

/// The bytes of a regular file of at most `max_bytes`.
Result<std::string> read_file(const std::filesystem::path& path,
                              std::size_t max_bytes = max_document_bytes);

/// Makes the folder, and those above it, unless it is there.
Status make_folder(const std::filesystem::path& path);

/// Writes beside `path` and renames, so that a reader sees the old file or the whole new one and a
/// full disk leaves no half-written file behind.
Status write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace roomgen
