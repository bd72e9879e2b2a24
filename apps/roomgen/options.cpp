#include "options.h"

#include <charconv>

#include "roomgen/base/text.h"

namespace roomgen::cli {

namespace {

bool parse_number(const std::string& text, double& value) {
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  return code == std::errc() && end == text.data() + text.size() && value > 0.0;
}

}  // namespace

Result<std::optional<Vec2>> parse_size(const std::string& text) {
  if (text.empty()) return std::optional<Vec2>();
  const auto pieces = split(lower(text), 'x');
  Vec2 size;
  if (pieces.size() != 2 || !parse_number(pieces[0], size.x()) || !parse_number(pieces[1], size.y()))
    return Error{Error::Kind::invalid_input,
                 "--size: \"" + text + "\" is no size; write width x depth in metres, as in 4x5"};
  return std::optional<Vec2>(size);
}

}  // namespace roomgen::cli
