#pragma once

#include <string>

#include "phrase_text.h"

namespace roomgen::create {

/// The longest phrase of place that begins there: "hanging from"; null if none does.
const Placement* placement_at(const PhraseText& text, std::size_t at, const Words& words);

/// What it says of the part before it and of the part after it.
void place_before(const Placement& placement, PartWish& part);
void place_after(const Placement& placement, PartWish& part);

/// Where a part is that stands so to the thing itself: "a lamp on it".
Place place_of(const std::string& relation);

/// "forty-five degrees against the one below" from `at`, which moves behind it; 0 if it is none.
double read_turn(const PhraseText& text, std::size_t& at);

}  // namespace roomgen::create
