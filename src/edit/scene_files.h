#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "roomgen/base/result.h"

namespace roomgen {

/// The two files of a session, as far as it needs them: scene.json and the journal beside it. A value of
/// functions, so that a test can put a file system below that tears, drops and reorders what was written
/// since the last sync().
struct SceneFiles {
  std::string scene_name, journal_name;  ///< for messages

  std::function<Result<std::string>()> read_scene;  ///< not_found if there is none
  /// In one step: the old bytes or the new ones, kept when it returns.
  std::function<Status(std::string_view)> write_scene;
  std::function<Result<std::string>()> read_journal;  ///< empty if there is none
  /// At the journal's end. Nothing of it is kept for certain before sync().
  std::function<Status(std::string_view)> append;
  std::function<Status()> sync;
  /// Drops what comes after so many bytes of the journal.
  std::function<Status(std::size_t)> cut;
};

/// Largest journal that is read: tens of thousands of changes, in about 1 GB of memory.
inline constexpr std::size_t max_journal_bytes = 128u << 20;

/// "room/scene.journal" for "room/scene.json".
std::filesystem::path journal_of(const std::filesystem::path& scene_file);

enum class SceneAccess {
  look,  ///< no lock, nothing is written
  edit   ///< the journal is locked until the files are let go; a second program gets an error
};

/// Those of the file system. Links and devices are refused. With SceneAccess::edit an empty journal is made.
Result<SceneFiles> open_scene_files(const std::filesystem::path& scene_file, SceneAccess access);

}  // namespace roomgen
