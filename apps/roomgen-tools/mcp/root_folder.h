#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roomgen/base/result.h"

namespace roomgen::mcp {

/// The folder that an agent may read and write, and nothing else of the disk. Paths are followed through their
/// links before they are judged. It guards against what an agent asks for, not against another program that
/// exchanges folders for links meanwhile.
class RootFolder {
 public:
  /// Fails if there is no such folder.
  static Result<RootFolder> open(const std::filesystem::path& folder);

  const std::filesystem::path& path() const { return path_; }

  /// Where a path leads that is relative to the root, or absolute and in it; the file need not be there.
  Result<std::filesystem::path> find(const std::string& path) const;
  /// The scene of a room: of its folder, or of its file. A file beside it that is a link leading out of the root
  /// is an error.
  Result<std::filesystem::path> find_scene(const std::string& room) const;
  /// As agents name it: relative to the root, with slashes.
  std::string name_of(const std::filesystem::path& path) const;

  /// The folders below the root with a scene.json, sorted, as agents name them: at most `most`. Links and hidden
  /// folders are not entered.
  std::vector<std::string> rooms(std::size_t most) const;

 private:
  explicit RootFolder(std::filesystem::path path) : path_(std::move(path)) {}
  bool holds(const std::filesystem::path& resolved) const;
  Error no_room(const std::string& room) const;

  std::filesystem::path path_;  ///< absolute, without links
};

}  // namespace roomgen::mcp
