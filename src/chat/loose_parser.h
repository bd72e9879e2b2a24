#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/json.h"

namespace roomgen {

/// Reads a value that is nearly JSON: comments, trailing and missing commas, quotes of any kind,
/// bare keys and words, Python's literals, round brackets, brackets that are missing or of the
/// wrong kind. Never goes back, so that the time is linear in the text.
class LooseParser {
 public:
  /// `at` is the first byte of the value.
  LooseParser(std::string_view text, std::size_t at) : text_(text), at_(at) {}

  /// Nothing if what stands there is prose or nested too deep.
  std::optional<Json> parse() { return value(0); }

  std::size_t position() const { return at_; }
  /// The text ended before the value did.
  bool truncated() const { return truncated_; }
  const std::vector<std::string>& repairs() const { return repairs_; }

 private:
  enum class Next { item, end, failed };

  std::optional<Json> value(int depth);
  std::optional<Json> object(int depth);
  std::optional<Json> array(int depth);
  std::optional<std::string> key();
  std::optional<std::string> string();
  Json bare();

  Next next_item(char closing);
  void skip_prose();
  void skip_space();
  bool skip_comment();
  bool at_end() const;
  bool ends_string(std::size_t after) const;
  void append_escape(std::string& out);
  std::optional<unsigned> hex_digits();
  std::size_t quote_length(std::size_t at) const;
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void note(const char* what);

  std::string_view text_;
  std::size_t at_;
  bool truncated_ = false;
  std::vector<std::string> repairs_;
};

}  // namespace roomgen
