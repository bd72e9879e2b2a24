#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brief/tokens.h"
#include "part_forms.h"
#include "roomgen/create/kinds.h"

namespace roomgen::create {

/// Words of place, number and purpose are no parts: "down the right side".
bool says_nothing(const std::string& word);

/// A sentence as words, and what the words from one place on may be. Places beyond the end hold
/// nothing.
class PhraseText {
 public:
  /// Parts and kinds must outlive it.
  PhraseText(const std::string& prompt, const PartForms& parts, const ShapeKinds& kinds);

  std::size_t size() const { return texts_.size(); }
  /// In lower case; "," stands for every mark.
  const std::string& operator[](std::size_t at) const { return texts_[at]; }
  bool is(std::size_t at, std::initializer_list<std::string_view> list) const;
  bool starts(std::size_t at, const std::vector<std::string>& phrase) const;
  std::string joined(std::size_t at, std::size_t length) const;

  /// A run of words from a place on, and what it means.
  template <typename T>
  struct Run {
    std::size_t length = 0;  ///< 0: nothing is known of the words
    T meaning{};

    explicit operator bool() const { return length > 0; }
  };
  /// The longest run that is in the map.
  template <typename T>
  Run<const T*> longest(const WordMap<T>& map, std::size_t at) const {
    Run<const T*> found;
    std::string phrase;
    for (std::size_t n = 0; n < most_run && at + n < size(); ++n) {
      phrase += (n ? " " : "") + texts_[at + n];
      if (const auto entry = map.find(phrase); entry != map.end()) found = {n + 1, &entry->second};
    }
    return found;
  }

  Run<const ShapeKind*> kind(std::size_t at) const;
  /// The labels of a part, the likeliest first; "legged" names legs too.
  Run<std::vector<std::string>> part(std::size_t at) const;
  /// As shape::parse_color() knows it: "dark blue" is "darkblue".
  Run<std::string> color(std::size_t at) const;
  /// In figures or as a word, vague ones aside.
  std::optional<double> number(std::size_t at) const;
  /// A number of things: "3", "two", "half a dozen"; articles are none.
  Run<int> count(std::size_t at) const;

  static constexpr int most_count = 50;

 private:
  static constexpr std::size_t most_run = 3;

  const PartForms& parts_;
  const ShapeKinds& kinds_;
  std::vector<design::Token> tokens_;
  std::vector<std::string> texts_;
};

}  // namespace roomgen::create
