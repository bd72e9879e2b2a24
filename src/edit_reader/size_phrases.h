#pragma once

#include "clause_parts.h"
#include "edit/new_size.h"

namespace roomgen {

/// "bigger", "much wider", "a bit less tall", "twice as long", "half the height"
std::optional<Read<Growth>> growth_at(const EditText& text, std::size_t at);
/// What "bigger" is to "big".
std::optional<Growth> growth_of_adjective(const EditText& text, const std::string& adjective);

/// "20 cm longer", "twice as wide", "30 cm deep", "bigger", "as wide as the desk": the size that a thing gets by it.
MayRead<NewSize> size_at(const EditText& text, std::size_t at);
/// Behind a verb of size: "by 20 cm", "to 1.8 m", "by a third", "to half its size", or nothing at all.
MayRead<NewSize> size_behind_verb(const EditText& text, std::size_t at, const Growth& verb);

/// "1.8 m", and `at` behind it.
std::optional<double> length_at(const EditText& text, std::size_t& at);

/// "the height of the stool", "the desk's width", "its depth"
struct SizedThings {
  Ids ids;
  std::string side;
};
std::optional<Read<SizedThings>> sized_things_at(const EditText& text, std::size_t at);

}  // namespace roomgen
