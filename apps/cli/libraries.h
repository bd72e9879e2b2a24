#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "command.h"
#include "roomgen/assets/catalogue.h"

namespace roomgen::cli {

/// The furniture libraries that a command works with.
struct LibraryOptions {
  std::vector<std::string> more;  ///< besides the installed ones
  bool only_these = false;
  std::string cache;  ///< empty: the user's cache folder
  bool rebuild = false;
  bool require_sandbox = false;  ///< fail where the decoder of meshes cannot be shut in
  bool verbose = false;  ///< tell what was repaired or left out
};

/// Adds --library, --no-default-libraries and --cache.
void add_library_options(CLI::App& command, LibraryOptions& options);

/// Opens them, with a progress line on a terminal while they are indexed.
Result<std::unique_ptr<assets::Catalogue>> open_libraries(const LibraryOptions& options,
                                                          const Context& context);

/// The folder that the options name, or else the user's.
std::filesystem::path cache_folder(const LibraryOptions& options);

/// Where `create --add` keeps programs, below the cache folder (empty: the user's).
std::filesystem::path kept_folder(const std::string& cache);

/// What was kept goes first, then the libraries, then what is made from words. Without any library, a
/// warning.
Result<std::unique_ptr<AssetLibrary>> open_all_libraries(const LibraryOptions& options,
                                                         const Context& context);

/// The same, opened when it is first asked: undo and history need none. Both arguments must outlive it.
std::unique_ptr<AssetLibrary> make_later_library(const LibraryOptions& options, const Context& context);

}  // namespace roomgen::cli
