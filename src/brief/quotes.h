#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "language/parse.h"

namespace roomgen::brief {

/// Words of a wish as others quote them: "two red chairs", "chairs #2" for where it says so the
/// second time.
class Quotes {
 public:
  /// `prompt` and `tokens`, which are its own, must outlive it.
  Quotes(std::string_view prompt, const std::vector<language::Token>& tokens);

  /// The tokens that a quote means, whatever its case, blanks and marks, in one run or, where it
  /// leaves words out, in several; none if the wish does not say so. Of several places the one that
  /// its number tells, else the nearest to `near`.
  std::vector<language::Run> find(std::string_view quote, std::uint32_t near) const;
  /// The same, but of several places without a number the first that begins at `from` or behind.
  std::vector<language::Run> find_from(std::string_view quote, std::uint32_t from) const;
  /// A quote that find() takes for just these tokens; empty if none would do.
  std::string quote(const language::Run& tokens) const;

 private:
  using Place = std::vector<language::Run>;
  std::vector<Place> places_of(std::string_view words) const;
  /// Those that are written just so, unless there are fewer than the one that is meant.
  std::vector<Place> places_of(std::string_view words, std::size_t number) const;
  std::vector<Place> places_apart(const std::vector<std::string>& words) const;

  std::string_view prompt_;
  const std::vector<language::Token>& tokens_;
  std::vector<std::uint32_t> spoken_;  ///< tokens that are no mere marks
  std::vector<std::string> plain_;     ///< their text
};

}  // namespace roomgen::brief
