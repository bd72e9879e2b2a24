#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"

namespace roomgen {

/// US dollars for a million tokens.
struct Price {
  double input = 0.0;
  double output = 0.0;

  double of(long long input_tokens, long long output_tokens) const {
    return (input * static_cast<double>(input_tokens) +
            output * static_cast<double>(output_tokens)) /
           1e6;
  }
};

/// What models cost, by the beginnings of their names.
class PriceTable {
 public:
  /// data/prices.json, compiled in.
  static PriceTable built_in();
  /// A table in the form of data/prices.json; `source` names it in errors.
  static Result<PriceTable> parse(std::string_view text, const std::string& source);

  /// The entry with the longest name that `model` is a version of: "gpt-4o" is for gpt-4o and
  /// gpt-4o-2024-08-06, not for gpt-4o-audio. A vendor before a slash (openai/gpt-4o) is ignored.
  std::optional<Price> find(std::string_view model) const;

 private:
  struct Entry {
    std::string name;
    Price price;
  };
  std::vector<Entry> entries_;
};

}  // namespace roomgen
