#pragma once

#include <optional>
#include <vector>

#include "phrase_text.h"

namespace roomgen::create {

/// Lengths that are said of a thing or a part: "80 cm tall", "120 x 60 x 75 cm".
struct Measure {
  std::size_t end = 0;          ///< the word behind them
  int axis = 0;                 ///< of the first: 0 width, 1 depth, 2 height; the others follow
  std::vector<double> lengths;  ///< metres
  bool thick = false;           ///< "2 cm thick"
};

/// Nothing if no length with a unit begins there.
std::optional<Measure> read_measure(const PhraseText& text, std::size_t at);

/// What a measure says of sides; NaN where it says nothing.
Vec3 sides(const Measure& measure);

/// "a top 2 cm thick", "legs 5 cm thick", "a back two metres tall".
void apply(const Measure& measure, PartWish& part);

}  // namespace roomgen::create
