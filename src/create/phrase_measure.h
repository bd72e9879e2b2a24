#pragma once

#include <optional>

#include "phrase_text.h"

namespace roomgen::create {

/// The lengths that begin there, with the side that a word before them says: "height 50 cm".
/// Nothing if there are none with a unit.
std::optional<language::Measure> read_measure(const PhraseText& text, std::size_t at);

/// What a measure says of width, depth and height; NaN where it says nothing.
Vec3 sides(const language::Measure& measure);

/// "a top 2 cm thick", "legs 5 cm thick", "a back two metres tall".
void apply(const language::Measure& measure, PartWish& part);

}  // namespace roomgen::create
