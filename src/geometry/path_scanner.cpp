#include "path_scanner.h"

#include "base/numbers.h"

namespace roomgen::detail {

bool PathScanner::at_end() {
  skip_separators(rest_);
  return rest_.empty();
}

std::optional<char> PathScanner::command() {
  constexpr std::string_view commands = "MmLlHhVvCcSsQqTtAaZz";
  if (at_end() || commands.find(rest_.front()) == std::string_view::npos) return std::nullopt;
  const char found = rest_.front();
  rest_.remove_prefix(1);
  return found;
}

std::optional<double> PathScanner::number() {
  skip_separators(rest_);
  return take_number(rest_);
}

std::optional<bool> PathScanner::flag() {
  if (at_end() || (rest_.front() != '0' && rest_.front() != '1')) return std::nullopt;
  const bool set = rest_.front() == '1';
  rest_.remove_prefix(1);
  return set;
}

}  // namespace roomgen::detail
