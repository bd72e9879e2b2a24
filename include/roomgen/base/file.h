#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
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

/// Writes beside `path` and renames: whoever reads sees the old file or the whole new one, also after a
/// crash, and a full disk leaves no half-written file behind. A link, a folder or a device of this name is
/// refused, not followed and not replaced.
Status write_file(const std::filesystem::path& path, std::string_view bytes);

/// The same for bytes that somebody else writes (a database): `write` is given an empty file of another
/// name in the same folder; if it fails, that goes and the old file stays.
Status replace_file(const std::filesystem::path& path,
                    const std::function<Status(const std::filesystem::path& aside)>& write);

/// A file that grows line by line while work goes on, as recordings do; what was appended is there even if
/// the program ends badly. Lines of two programs do not mix.
class AppendedFile {
 public:
  /// Makes the file or goes on at its end. Links and devices are refused.
  static Result<AppendedFile> open(const std::filesystem::path& path);
  AppendedFile(AppendedFile&&) noexcept;
  AppendedFile& operator=(AppendedFile&&) noexcept;
  ~AppendedFile();

  Status append(std::string_view line) const;

 private:
  struct Impl;
  explicit AppendedFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

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

  /// Writes the file of this relative name ("marks/step-00.png"), after the folders above it. Fails if the
  /// folder holds something of that name that is no file.
  Status write(const std::filesystem::path& relative, std::string_view bytes) const;
  /// The same by somebody else, who is told where it is to be written now. Its errors name the file by the
  /// place that it is to have.
  using Writer = std::function<Status(const std::filesystem::path& now)>;
  Status write_with(const std::filesystem::path& relative, const Writer& writer) const;

  /// Once, at the end.
  Status commit();

 private:
  struct Impl;
  explicit OutputFolder(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace roomgen
