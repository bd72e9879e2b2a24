#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <utility>

namespace roomgen::detail {

/// An open file or folder of the operating system, closed with its owner. errno says why something
/// failed. (descriptor_posix.cpp, descriptor_windows.cpp)
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { (void)close(); }

  /// A new file to be written; empty if anything has that name, be it a link that leads nowhere.
  static Descriptor create(const std::filesystem::path& path);
  /// A file that all is written to the end of, made if it is not there; empty for links and folders.
  static Descriptor open_to_append(const std::filesystem::path& path);

  explicit operator bool() const { return number_ >= 0; }
  int number() const { return number_; }

  /// A regular file, and no device or pipe.
  bool is_file() const;
  /// Holds the file until closed, or until the process is no more; false if another one holds it.
  bool lock() const;
  /// Shortens the file to so many bytes.
  bool cut(std::size_t size) const;
  /// False if not all was taken.
  bool write(std::string_view bytes) const;
  /// What was written survives a crash from here on, where the file system knows such a thing.
  bool sync() const;
  /// False when what was written before is lost after all.
  bool close();

 private:
  int number_ = -1;
};

}  // namespace roomgen::detail
