#include "numbers.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/shape/program.h"

namespace roomgen::shape::detail {

namespace {

// Of all formulas of a document and what it uses, in numbers, names and operators.
constexpr std::size_t max_work = 4'000'000;

// Names of materials of recipes that use each other are joined.
constexpr std::size_t max_reference = 1000;

std::string range(double low, double high) {
  return "from " + format_number(low, 6) + " to " + format_number(high, 6);
}

template <typename Point, typename ReadPoint>
Curve<Point> read_curve(const JsonReader& json, const Numbers& numbers,
                        const std::string& points_key, const std::string& corners_key,
                        ReadPoint read_point) {
  Curve<Point> curve;
  const auto elements = json[points_key].elements(max_curve_points);
  if (!numbers.spend(json, elements.size())) return curve;
  for (const auto& element : elements) curve.points.push_back(read_point(element));
  const auto corners = json[corners_key];
  if (corners.is_string()) {
    if (corners.text() != "all") corners.report("expected \"all\" or an array of indices");
    for (std::size_t i = 0; i < curve.points.size(); ++i) curve.corners.push_back(i);
  } else {
    for (const auto& corner : corners.elements_or_none(max_curve_points))
      curve.corners.push_back(static_cast<std::size_t>(
          numbers.whole(corner, 0, std::max(0, static_cast<int>(curve.points.size()) - 1))));
  }
  return curve;
}

void require_points(const JsonReader& json, std::size_t found, bool closed) {
  const std::size_t least = closed ? 3 : 2;
  if (json.is_array() && found < least)
    json.report("expected " + std::to_string(least) + " points or more");
}

}  // namespace

bool Numbers::spend(const JsonReader& json, std::size_t work) const {
  reading_->work += work;
  if (reading_->work <= max_work) return true;
  json.report("the program takes too much work to read; use fewer copies and formulas");
  return false;
}

const Expression* Numbers::compiled(const JsonReader& json, std::size_t limit) const {
  const std::string text = json.text(limit);
  auto known = reading_->formulas.find(text);
  if (known == reading_->formulas.end()) {
    auto expression = Expression::compile(text, limit);
    if (!expression) {
      json.report("\"" + text.substr(0, 60) + "\": " + expression.error().message);
      return nullptr;
    }
    known = reading_->formulas.emplace(text, *std::move(expression)).first;
  }
  const Expression& formula = known->second;
  if (!spend(json, formula.size())) return nullptr;
  used.i = used.i || formula.mentions("i");
  used.j = used.j || formula.mentions("j");
  return &formula;
}

std::optional<Value> Numbers::evaluated(const JsonReader& json) const {
  const Expression* expression = compiled(json, Expression::max_length);
  if (!expression) return std::nullopt;
  auto value = expression->value(*scope_);
  if (value) return *std::move(value);
  json.report("\"" + json.text() + "\": " + value.error().message);
  return std::nullopt;
}

double Numbers::number(const JsonReader& json, double low, double high) const {
  if (!json.is_string()) return roomgen::rounded(json.number(low, high), 6);
  if (!scope_) {
    json.report("expected a number " + range(low, high) +
                "; formulas belong in recipes, this program is concrete");
    return low;
  }
  const auto value = evaluated(json);
  if (!value) return low;
  if (!std::holds_alternative<double>(*value)) {
    json.report("\"" + json.text() + "\" is the word " + to_text(*value) + "; expected a number");
    return low;
  }
  const double result = roomgen::rounded(std::get<double>(*value), 6);
  if (result >= low && result <= high) return result;
  json.report("\"" + json.text() + "\" is " + format_number(result, 6) +
              ", out of range; expected a number " + range(low, high));
  return low;
}

double Numbers::number_or(const JsonReader& json, double fallback, double low, double high) const {
  return json.exists() ? number(json, low, high) : fallback;
}

int Numbers::whole(const JsonReader& json, int low, int high) const {
  const double value = number(json, low, high);
  if (value != std::floor(value))
    json.report(format_number(value, 6) + " is not whole; expected a whole number " +
                range(low, high));
  return static_cast<int>(value);
}

int Numbers::whole_or(const JsonReader& json, int fallback, int low, int high) const {
  return json.exists() ? whole(json, low, high) : fallback;
}

double Numbers::length(const JsonReader& json) const {
  return number(json, least_length, greatest_length);
}

double Numbers::length_or_zero(const JsonReader& json, double fallback) const {
  return number_or(json, fallback, 0.0, greatest_length);
}

double Numbers::angle_or(const JsonReader& json, double fallback_degrees, double low,
                         double high) const {
  return radians(number_or(json, fallback_degrees, low, high));
}

std::vector<JsonReader> Numbers::tuple(const JsonReader& json, std::size_t count) const {
  auto elements = json.elements();
  if (json.is_array() && elements.size() != count)
    json.report("expected an array of " + std::to_string(count) + " numbers");
  if (elements.size() != count) elements.clear();
  return elements;
}

Vec2 Numbers::vec2(const JsonReader& json, double low, double high) const {
  const auto e = tuple(json, 2);
  return e.empty() ? Vec2::Ones() : Vec2(number(e[0], low, high), number(e[1], low, high));
}

Vec3 Numbers::vec3(const JsonReader& json, double low, double high) const {
  const auto e = tuple(json, 3);
  return e.empty()
             ? Vec3::Ones()
             : Vec3(number(e[0], low, high), number(e[1], low, high), number(e[2], low, high));
}

Vec2 Numbers::size2(const JsonReader& json) const {
  return vec2(json, least_length, greatest_length);
}

Vec3 Numbers::size3(const JsonReader& json) const {
  return vec3(json, least_length, greatest_length);
}

Value Numbers::value(const JsonReader& json) const {
  if (!json.is_string()) return roomgen::rounded(json.number(-1e9, 1e9), 6);
  auto value = evaluated(json).value_or(Value(0.0));
  if (auto* number = std::get_if<double>(&value)) *number = roomgen::rounded(*number, 9);
  return value;
}

std::string Numbers::word(const JsonReader& json, std::string fallback) const {
  const std::string text = json.text_or(std::move(fallback), max_reference);
  if (!scope_ || text.empty() || text[0] != '$') return text;
  const auto found = scope_->values.find(text.substr(1));
  if (found == scope_->values.end()) {
    json.report("no parameter or let is called \"" + text.substr(1) + "\"");
  } else if (const auto* word = std::get_if<std::string>(&found->second)) {
    return *word;
  } else {
    json.report("\"" + text.substr(1) + "\" is a number; expected a word");
  }
  return {};
}

std::string Numbers::height(const JsonReader& json) const {
  Scope none;
  if (!json.is_string()) return Json(number(json, 0.0, greatest_length)).dump();
  const Expression* expression = compiled(json, scope_ ? Expression::max_length : Expression::max_bound_length);
  if (!expression) return "0";
  auto text = expression->bound(scope_ ? *scope_ : none, {"u", "v"});
  if (text && text->size() <= Expression::max_bound_length) return *std::move(text);
  json.report("\"" + json.text().substr(0, 60) +
              "\": " + (text ? "too long with all numbers put in" : text.error().message));
  return "0";
}

Curve<Vec2> read_curve2(const JsonReader& json, const Numbers& numbers,
                        const std::string& points_key, const std::string& corners_key,
                        bool closed) {
  auto curve =
      read_curve<Vec2>(json, numbers, points_key, corners_key, [&](const JsonReader& point) {
        return numbers.vec2(point, -greatest_length, greatest_length);
      });
  curve.closed = closed;
  require_points(json[points_key], curve.points.size(), closed);
  return curve;
}

Curve<Vec3> read_curve3(const JsonReader& json, const Numbers& numbers,
                        const std::string& points_key, const std::string& corners_key,
                        bool closed) {
  auto curve =
      read_curve<Vec3>(json, numbers, points_key, corners_key, [&](const JsonReader& point) {
        return numbers.vec3(point, -greatest_length, greatest_length);
      });
  curve.closed = closed;
  require_points(json[points_key], curve.points.size(), closed);
  return curve;
}

}  // namespace roomgen::shape::detail
