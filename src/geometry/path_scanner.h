#pragma once

#include <optional>
#include <string_view>

namespace roomgen::detail {

/// Takes commands and numbers from the front of an SVG path, and passes over the white space and
/// commas before them.
class PathScanner {
 public:
  explicit PathScanner(std::string_view path) : path_(path), rest_(path) {}

  /// The byte at which it goes on.
  std::size_t position() const { return path_.size() - rest_.size(); }
  bool at_end();
  std::optional<char> command();
  std::optional<double> number();
  /// Flags of an arc need nothing between them: "a1,1 0 011,0".
  std::optional<bool> flag();

 private:
  std::string_view path_, rest_;
};

}  // namespace roomgen::detail
