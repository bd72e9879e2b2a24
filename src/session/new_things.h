#pragma once

#include "clause_parts.h"

namespace roomgen {

/// "a keyboard", "another keyboard", "keyboard" where there is none yet, with what is said of it behind the name: "a
/// vase of tulips", "a round one in pale ash that seats six", "a second crib, identical to the first".
std::optional<NamedThing> new_thing_at(const EditText& text, std::size_t at);

/// "a monitor and a keyboard"
std::vector<NamedThing> new_things_at(const EditText& text, std::size_t at);

/// Words behind a name that say what such a thing is like, and the token behind them; `at` if there are none.
Read<std::string> description_behind(const EditText& text, std::size_t at);

}  // namespace roomgen
