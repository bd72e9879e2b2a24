#include "plain_reply.h"

#include <array>
#include <charconv>

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::size_t longest_line = 500;  ///< bytes; prose is longer

// What people write before and around a list: bullets, quotes, "Constraints:".
std::string_view bare(std::string_view line) {
  constexpr std::string_view ornaments = " \t\r-*>`\"'.;";
  const auto strip = [&] {
    while (!line.empty() && ornaments.find(line.front()) != std::string_view::npos)
      line.remove_prefix(1);
    while (!line.empty() && ornaments.find(line.back()) != std::string_view::npos)
      line.remove_suffix(1);
  };
  strip();
  constexpr std::string_view label = "constraints";
  if (lower(line.substr(0, label.size())) == label) {
    line.remove_prefix(label.size());
    if (const auto colon = line.find(':'); colon != std::string_view::npos && colon <= 4)
      line.remove_prefix(colon + 1);
    strip();
  }
  return line;
}

// Prose speaks of edges and corners too, but does not begin a list with nothing else.
bool is_list_of_constraints(std::string_view line) {
  if (line.empty() || line.size() > longest_line) return false;
  const std::string first = lower(trim(line.substr(0, line.find('|'))));
  const bool global = first == "edge" || first == "middle" || first == "corner";
  return global || (line.find('|') != std::string_view::npos &&
                    first.find(',') != std::string::npos && words(first).size() <= 6);
}

// The point whose opening bracket is at `open`.
std::optional<std::array<double, 2>> point_at(std::string_view text, std::size_t open) {
  std::array<double, 2> point{};
  const char* at = text.data() + open + 1;
  const char* const end = text.data() + text.size();
  const auto skip_spaces = [&] {
    while (at < end && *at == ' ') ++at;
  };
  for (std::size_t axis = 0; axis < 2; ++axis) {
    skip_spaces();
    const auto [after, error] = std::from_chars(at, end, point[axis]);
    if (error != std::errc()) return std::nullopt;
    at = after;
    skip_spaces();
    if (at == end || *at != (axis == 0 ? ',' : text[open] == '(' ? ')' : ']')) return std::nullopt;
    ++at;
  }
  return point;
}

}  // namespace

std::optional<Json> read_plain_reply(std::string_view text) {
  std::string_view constraints;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const auto line = bare(text.substr(begin, end - begin));
    if (is_list_of_constraints(line)) constraints = line;
    begin = end + 1;
  }
  if (constraints.empty()) return std::nullopt;
  Json answer = {{"constraints", std::string(constraints)}};
  for (auto at = text.find_last_of("([");; at = text.find_last_of("([", at - 1)) {
    if (at == std::string_view::npos) break;
    if (const auto point = point_at(text, at)) {
      answer["location"] = *point;
      break;
    }
    if (at == 0) break;
  }
  return answer;
}

}  // namespace roomgen
