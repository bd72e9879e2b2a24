#pragma once

#include "clause_parts.h"

namespace roomgen {

/// "a keyboard", "another keyboard", "keyboard" where there is none yet, with what is said of it behind the name: "a
/// vase of tulips", "a round one in pale ash that seats six", "a second crib, identical to the first".
/// `may_be_bare`: what no kind is called may stand without an article, as behind "add".
std::optional<NamedThing> new_thing_at(const EditText& text, std::size_t at, bool may_be_bare = false);

/// "a monitor and a keyboard"
std::vector<NamedThing> new_things_at(const EditText& text, std::size_t at, bool may_be_bare = false);

/// Words behind a name that say what such a thing is like, and the token behind them; `at` if there are none.
/// `kind`: what is described, null for another of a kind that is known.
Read<std::string> description_behind(const EditText& text, std::size_t at, const Kind* kind = nullptr);

}  // namespace roomgen
