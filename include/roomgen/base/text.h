#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace roomgen {

/// ASCII lower case; other bytes (UTF-8) are kept.
std::string lower(std::string_view text);
/// Without white space at both ends.
std::string_view trim(std::string_view text);
/// The pieces between separators, each trimmed; empty pieces are kept.
std::vector<std::string> split(std::string_view text, char separator);
/// What a terminal may be given, whoever wrote it: control characters but line ends, characters that turn
/// the direction of writing, and bytes that are no UTF-8 become '?'.
std::string printable(std::string_view text);
/// At most `limit` bytes, ending with a whole UTF-8 character.
std::string shortened(std::string text, std::size_t limit);
std::string join(const std::vector<std::string>& pieces, std::string_view separator);
/// Lower-case words of letters and digits; everything else separates ("Coffee-Table 2" gives coffee,
/// table, 2).
std::vector<std::string> words(std::string_view text);
/// Shortest decimal text of a number with at most `decimals` places, '.' as the point whatever the
/// locale: 1.5, 2, -0.25.
std::string format_number(double value, int decimals = 3);
/// An English noun in the singular, by its ending alone: shelves gives shelf, boxes box, glass glass.
std::string singular(std::string word);
/// Bytes inserted, dropped, replaced or swapped with their neighbour (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b);
/// Of `names`, the one nearest to `name` if it is close enough to be a misspelling, else empty.
std::string closest_name(std::string_view name, const std::vector<std::string>& names);

}  // namespace roomgen
