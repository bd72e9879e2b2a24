#pragma once

#include <filesystem>
#include <optional>

#include "room_session.h"

namespace roomgen::repl {

/// A room that stays open for many lines. Nobody else may edit it meanwhile; who changes scene.json by hand
/// is noticed with the next line, and the change becomes part of the history.
class OpenScene {
 public:
  static Result<OpenScene> open(std::filesystem::path file, const AssetLibrary& library, cli::RoomAccess access);

  const std::filesystem::path& file() const { return file_; }
  /// The room as it is now on disk.
  Result<Session*> session();

 private:
  OpenScene(std::filesystem::path file, const AssetLibrary& library, cli::RoomAccess access)
      : file_(std::move(file)), library_(&library), access_(std::move(access)) {}
  Status reopen();
  bool is_changed_by_hand() const;

  std::filesystem::path file_;
  const AssetLibrary* library_;
  cli::RoomAccess access_;
  std::optional<Session> session_;
};

}  // namespace roomgen::repl
