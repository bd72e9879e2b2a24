#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "language/token.h"
#include "roomgen/lab/compose.h"

namespace roomgen::lab::compose {

/// data/program/complexity.json: how people say how much a room shall hold.
struct ComplexityWords {
  /// Words of a pattern, one for each place: alternatives; "#" an amount, ".." up to three words.
  using Pattern = std::vector<std::vector<std::string>>;
  struct Measure {
    std::map<std::string, Range, std::less<>> levels;                    ///< "low" to its range
    std::vector<Pattern> patterns;
    std::map<std::string, std::vector<std::string>, std::less<>> words;  ///< by level: what says it alone
  };
  std::map<std::string, std::vector<std::string>, std::less<>> level_words;
  std::vector<std::string> denied_by;
  /// Kinds that make up what is missing: seats, shelves, covered floor, small things.
  std::map<std::string, std::vector<std::string>, std::less<>> made_up_with;
  std::map<std::string, Measure, std::less<>> measures;
};
const ComplexityWords& complexity_words();

/// Where a text says what complexity_of() reads of it.
struct MeasureSpan {
  std::string measure;
  language::Span span;
};
/// In the order of the text.
std::vector<MeasureSpan> complexity_spans(std::string_view text);

}  // namespace roomgen::lab::compose
