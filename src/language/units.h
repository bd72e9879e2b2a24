#pragma once

#include <vector>

#include "measure.h"
#include "number.h"
#include "parse.h"

namespace roomgen::language {

/// What does one thing in a sentence: a word or several joined by hyphens, a number, a measure, a
/// mark. Words of several parts that stand apart ("in front of") are several units.
struct Unit {
  enum class Kind : std::uint8_t { word, number, measure, comma, stop };

  Kind kind = Kind::word;
  Run tokens;
  double value = 0.0;  ///< of a number
  Measure measure;
};

/// Cuts a text; quotes and symbols are left out.
std::vector<Unit> units(const std::vector<Token>& tokens);

}  // namespace roomgen::language
