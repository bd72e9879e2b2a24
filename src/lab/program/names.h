#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace roomgen::lab {

/// May a set, a variable, a parameter, a relation, a constraint or a score be called so?
bool is_program_name(std::string_view text);
/// The sets that every program has: objects, room, doors, windows, in the order of ProgramSet::Source; no other set is called so.
inline constexpr std::array<std::string_view, 4> given_sets = {"objects", "room", "doors", "windows"};
bool is_given_set(std::string_view text);

/// "; did you mean "desk"?" or "; known are desk, bed", whichever helps.
std::string suggestion(std::string_view word, const std::vector<std::string>& known);

}  // namespace roomgen::lab
