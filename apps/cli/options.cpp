#include "options.h"

#include <charconv>
#include <optional>
#include <string_view>

#include "roomgen/base/text.h"

namespace roomgen::cli {

namespace {

std::optional<double> parse_number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

Result<Vec2> parse_size(const std::string& text) {
  const auto sides = split(lower(text), 'x');
  if (sides.size() == 2)
    if (const auto width = parse_number(sides[0]), depth = parse_number(sides[1]); width && depth)
      return Vec2(*width, *depth);
  return Error{Error::Kind::invalid_input,
               "\"" + text + "\" is no size; write width and depth in metres, as in 4x5"};
}

Result<Vec3> parse_size3(const std::string& text) {
  const auto sides = split(lower(text), text.find(',') != std::string::npos ? ',' : 'x');
  if (sides.size() == 3) {
    const auto width = parse_number(sides[0]), depth = parse_number(sides[1]),
               height = parse_number(sides[2]);
    if (width && depth && height && *width > 0 && *depth > 0 && *height > 0)
      return Vec3(*width, *depth, *height);
  }
  return Error{Error::Kind::invalid_input,
               "\"" + text + "\" is no size; write width, depth and height in metres, as in "
               "0.4x0.4x0.7"};
}

}  // namespace roomgen::cli
