#pragma once

#include <optional>

#include "edit_text.h"

namespace roomgen {

void cut(EditText& text, std::size_t begin, std::size_t end);
/// The text without some of its words.
EditText without(const EditText& text, std::size_t begin, std::size_t end);
void insert_word(EditText& text, std::size_t at, const std::string& word);

/// The same with the place of a clause behind it: "on the desk, put a lamp" is "put a lamp on the desk". Nothing where
/// the clause does not begin with a place.
std::optional<EditText> with_place_last(const EditText& text, std::size_t at);

/// "half a metre further left with the desk" as "the desk half a metre further left".
std::optional<EditText> with_way_last(const EditText& text, std::size_t at);

/// The same with `X with Y` as `Y` on both sides of `X`, from `at` on: "flank the sofa with two lamps".
std::optional<EditText> with_flanks(const EditText& text, std::size_t at);

}  // namespace roomgen
