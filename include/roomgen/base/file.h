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

}  // namespace roomgen
