#pragma once

#include <optional>
#include <string_view>

namespace roomgen {

/// Takes a decimal number ("-1.5e3") from the front of the text, whatever the locale; nothing, and
/// the text as it was, if none is there or if it is not finite.
std::optional<double> take_number(std::string_view& text);
/// Drops white space and commas from the front.
void skip_separators(std::string_view& text);

}  // namespace roomgen
