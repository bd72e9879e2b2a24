#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace roomgen::create::detail {

/// What a label says about a part's place among the others: by its last word ("front leg" is a
/// leg), in the singular.

/// The words that the label's part is usually joined to; empty when nothing is known.
std::vector<std::string_view> usual_neighbours(const std::string& label);
/// Is one of the words the label's last one?
bool is_one_of(const std::string& label, const std::vector<std::string_view>& words);

/// Legs, feet, wheels: all of them reach the floor.
bool is_foot(const std::string& label);
/// Bases, pedestals, plinths: they reach the floor where there are no feet.
bool is_base(const std::string& label);
/// Something that nothing rests on: handles, knobs, cushions, books.
bool is_decorative(const std::string& label);

}  // namespace roomgen::create::detail
