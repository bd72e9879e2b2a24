#include "letters.h"

#include <algorithm>
#include <map>

#include "base/json_reader.h"
#include "base/json_values.h"
#include "base/resource.h"
#include "roomgen/base/text.h"

namespace roomgen::shape {

namespace {

struct Letter {
  double width = 0.0;
  std::vector<Curve<Vec2>> lines;
};

struct Font {
  double gap = 0.0, space = 0.0, line = 1.0;
  std::map<char, Letter> letters;
};

std::vector<Vec2> glyph_points(const JsonReader& json) {
  std::vector<Vec2> points;
  for (const auto& point : json.elements()) {
    const auto pair = point.numbers(2, -1.0, 2.0);
    points.emplace_back(pair[0], pair[1]);
  }
  return points;
}

Letter letter_of(const JsonReader& json) {
  Letter letter{json["width"].number(0.0, 2.0), {}};
  for (const auto& line : json["sharp"].elements_or_none())
    letter.lines.push_back(straight(glyph_points(line), false));
  for (const auto& line : json["smooth"].elements_or_none())
    letter.lines.push_back({glyph_points(line), {}, false});
  for (const auto& line : json["closed"].elements_or_none())
    letter.lines.push_back({glyph_points(line), {}, true});
  return letter;
}

const Font& font() {
  static const Font built_in = [] {
    Font result;
    const Json json = json_literal(*resource("data/letters.json"));
    JsonReader::Problems problems("data/letters.json");
    const JsonReader root(json, problems);
    result.gap = root["gap"].number(0.0, 2.0);
    result.space = root["space"].number(0.0, 2.0);
    result.line = root["line"].number(0.5, 5.0);
    for (const auto& [name, letter] : root["letters"].members())
      result.letters[name.front()] = letter_of(letter);
    return result;
  }();
  return built_in;
}

// From x = 0; the width, without the gap behind the last letter.
double add_line(std::string_view words, std::vector<Curve<Vec2>>& lines) {
  double x = 0.0;
  for (char c : words) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    const auto found = font().letters.find(c);
    if (found == font().letters.end()) {
      x += font().space;
      continue;
    }
    for (auto line : found->second.lines) {
      for (auto& point : line.points) point.x() += x;
      lines.push_back(std::move(line));
    }
    x += found->second.width + font().gap;
  }
  return std::max(0.0, x - font().gap);
}

}  // namespace

Lettering lettering(std::string_view words, Align align, double height, const Vec2& fit) {
  std::vector<Curve<Vec2>> result;
  const auto rows = split(words.substr(0, most_letters), '\n');
  const double tall = font().line * static_cast<double>(rows.size() - 1) + 1.0;
  double widest = 0.0;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    std::vector<Curve<Vec2>> lines;
    const double width = add_line(rows[row], lines);
    widest = std::max(widest, width);
    const double share = align == Align::left ? 0.0 : align == Align::center ? 0.5 : 1.0;
    const Vec2 move(-share * width,
                    tall - 1.0 - font().line * static_cast<double>(row) - 0.5 * tall);
    for (auto& line : lines) {
      for (auto& point : line.points) point += move;
      result.push_back(std::move(line));
    }
  }
  if (fit.x() > 0.0 && widest > 0.0) height = std::min(height, fit.x() / widest);
  if (fit.y() > 0.0) height = std::min(height, fit.y() / tall);
  for (auto& line : result)
    for (auto& point : line.points) point *= height;
  return {std::move(result), height};
}

}  // namespace roomgen::shape
