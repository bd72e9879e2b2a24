#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "roomgen/base/result.h"

namespace roomgen {

/// A folder of results that changes as a whole: everything is written beside it, where nobody looks, and
/// commit() puts it in its place at once. Whatever happens before that (an error, a full disk, the end of
/// the program) leaves the folder as it was, or leaves none where none was.
///
/// What the folder holds besides survives, subfolders too, unless it has the name of something written or
/// `ours` knows it as part of an earlier result. The folder itself may be given as a link; links, devices
/// and the like inside it are never followed, and refused where a result wants their name.
///
/// A folder that cannot be exchanged as a whole (a mount point, the folder in which the program was
/// started, one that belongs to somebody else) is changed file by file at the commit: each file is the old
/// or the new one, and the moment in which they are mixed is as short as that takes.
class OutputFolder {
 public:
  /// Does a path, relative to the folder, belong to an earlier result? Then it goes unless it is
  /// written anew.
  using Ours = std::function<bool(const std::filesystem::path& relative)>;

  /// Makes what is needed to write, the folders above included. Fails if the folder is no folder or
  /// cannot be written. What runs that were killed left beside the folder is removed.
  static Result<OutputFolder> open(const std::filesystem::path& folder, Ours ours = {});
  OutputFolder(OutputFolder&&) noexcept;
  OutputFolder& operator=(OutputFolder&&) noexcept;
  /// Without a commit, nothing has happened.
  ~OutputFolder();

  /// Where the file of this relative name ("marks/step-00.png") is to be written now; the folders above
  /// it are made. Fails if the folder holds something of that name that is no file.
  Result<std::filesystem::path> place_for(const std::filesystem::path& relative) const;
  Status write(const std::filesystem::path& relative, std::string_view bytes) const;

  /// Once, at the end.
  Status commit();

 private:
  struct Impl;
  explicit OutputFolder(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace roomgen
