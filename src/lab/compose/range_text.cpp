#include <charconv>
#include <cmath>

#include "roomgen/base/text.h"
#include "roomgen/lab/compose.h"

namespace roomgen::lab {

namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();
constexpr double margin_of_one_share = 0.03;

// "0.4", "40%"; nothing else.
std::optional<double> number_from(std::string text) {
  text = trim(text);
  const bool is_percent = text.ends_with('%');
  if (is_percent) text.pop_back();
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= 0.0 && value <= 1e4)) return std::nullopt;
  return is_percent ? value / 100.0 : value;
}

}  // namespace

std::string range_text(const Range& range) {
  if (std::isinf(range.high)) return "at least " + format_number(range.low, 2);
  if (range.low <= 0.0) return "at most " + format_number(range.high, 2);
  if (range.low == range.high) return format_number(range.low, 2);
  return format_number(range.low, 2) + " to " + format_number(range.high, 2);
}

Result<Range> range_from(std::string_view text, const std::string& option, double most) {
  const auto wrong = [&] {
    return Error{Error::Kind::invalid_input,
                 option + ": \"" + std::string(text) + "\" is no range; write 12, 8..12, 8.. or ..12"};
  };
  const auto beyond = [&] {
    return Error{Error::Kind::invalid_input, option + ": \"" + std::string(text) + "\" is beyond " +
                                                 format_number(most, 2) + "; write a share as 0.4..0.5 or 40%"};
  };
  const auto dots = text.find("..");
  if (dots == std::string_view::npos) {
    const auto value = number_from(std::string(text));
    if (!value) return wrong();
    if (*value > most) return beyond();
    const double margin = *value > 0.0 && *value < 1.0 ? margin_of_one_share : 0.0;
    return Range{*value - margin, *value + margin};
  }
  const std::string first(text.substr(0, dots)), last(text.substr(dots + 2));
  const auto low = trim(first).empty() ? std::optional(0.0) : number_from(first);
  const auto high = trim(last).empty() ? std::optional(no_bound) : number_from(last);
  if (!low || !high || *low > *high) return wrong();
  if (*low > most || (*high > most && *high < no_bound)) return beyond();
  return Range{*low, *high};
}

}  // namespace roomgen::lab
