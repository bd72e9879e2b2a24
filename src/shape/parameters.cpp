#include "parameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "color.h"
#include "expression_parser.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen::shape {

namespace detail {

namespace {

constexpr std::size_t max_parameters = 64, max_lets = 256, max_choices = 64, max_text = 240;
constexpr double max_value = 1e6;

bool is_identifier(std::string_view text) {
  if (text.empty() || text.size() > 64 || (text[0] >= '0' && text[0] <= '9')) return false;
  return std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

void require_free_name(const JsonReader& json, const std::string& name) {
  static const std::set<std::string, std::less<>> taken = {"i",  "j",  "n",   "u",  "v",
                                                           "pi", "or", "and", "not"};
  if (!is_identifier(name))
    json.report("\"" + name.substr(0, 60) + "\" is no name; use letters, digits and _");
  else if (taken.count(name) || arity(name))
    json.report("\"" + name + "\" has a meaning of its own; choose another name");
}

bool is_choice(const Parameter& parameter, const std::string& word) {
  return std::find(parameter.choices.begin(), parameter.choices.end(), word) !=
         parameter.choices.end();
}

std::string objection_to_word(const Parameter& parameter, const std::string& word) {
  if (!wants_word(parameter)) return "\"" + word + "\" is no number";
  if (parameter.color)
    return parse_color(word) ? "" : "\"" + word + "\" is no colour; write \"#rrggbb\" or a name";
  if (parameter.text) return word.size() <= max_text ? "" : "longer than 240 bytes";
  if (is_choice(parameter, word)) return "";
  return "\"" + word + "\" is none of " + join(parameter.choices, ", ");
}

Parameter read_number(const JsonReader& json, Parameter parameter) {
  json.allow_only({"value", "min", "max", "integer", "about"});
  parameter.integer = json["integer"].boolean_or(false);
  parameter.min = json["min"].number(-max_value, max_value);
  parameter.max = json["max"].number(-max_value, max_value);
  parameter.value = json["value"].number(-max_value, max_value);
  if (parameter.min > parameter.max) json["min"].report("\"min\" is above \"max\"");
  return parameter;
}

Parameter read_word(const JsonReader& json, Parameter parameter) {
  if (json["choices"].exists()) {
    json.allow_only({"value", "choices", "about"});
    for (const auto& choice : json["choices"].elements(max_choices))
      parameter.choices.push_back(choice.text(64));
    if (parameter.choices.empty()) json["choices"].report("expected at least one word");
  } else {
    json.allow_only({"value", "color", "text", "about"});
    parameter.color = json["color"].boolean_or(false);
    parameter.text = json["text"].boolean_or(false);
    if (parameter.color == parameter.text)
      json.report("a word needs \"choices\", a colour \"color\": true, free text \"text\": true");
  }
  parameter.value = json["value"].text(max_text);
  return parameter;
}

}  // namespace

std::vector<Parameter> read_parameters(const JsonReader& parameters) {
  std::vector<Parameter> result;
  for (const auto& [name, json] : parameters.members()) {
    if (result.size() == max_parameters) {
      parameters.report("more than " + std::to_string(max_parameters) + " parameters");
      break;
    }
    require_free_name(json, name);
    Parameter parameter;
    parameter.name = name;
    parameter.about = json["about"].text_or("", 500);
    const bool word = json["choices"].exists() || json["value"].is_string();
    parameter =
        word ? read_word(json, std::move(parameter)) : read_number(json, std::move(parameter));
    if (const auto wrong = objection(parameter, parameter.value); !wrong.empty())
      json["value"].report(wrong);
    result.push_back(std::move(parameter));
  }
  return result;
}

bool wants_word(const Parameter& parameter) {
  return !parameter.choices.empty() || parameter.color || parameter.text;
}

std::string objection(const Parameter& parameter, const Value& value) {
  if (const auto* word = std::get_if<std::string>(&value))
    return objection_to_word(parameter, *word);
  const double number = std::get<double>(value);
  if (wants_word(parameter))
    return parameter.color  ? "expected a colour"
           : parameter.text ? "expected words"
                           : "expected one of " + join(parameter.choices, ", ");
  if (!(number >= parameter.min && number <= parameter.max))
    return format_number(number, 6) + " is out of range; expected a number from " +
           format_number(parameter.min, 6) + " to " + format_number(parameter.max, 6);
  if (parameter.integer && number != std::floor(number))
    return format_number(number, 6) + " is not whole; expected a whole number from " +
           format_number(parameter.min, 6) + " to " + format_number(parameter.max, 6);
  return "";
}

Scope make_scope(const std::vector<Parameter>& parameters, const Values& values,
                 std::uint64_t seed) {
  Scope scope;
  scope.seed = seed;
  for (const auto& parameter : parameters) {
    const auto given = values.find(parameter.name);
    scope.values[parameter.name] = given == values.end() ? parameter.value : given->second;
    scope.words.insert(parameter.choices.begin(), parameter.choices.end());
  }
  return scope;
}

void add_lets(const JsonReader& lets, const Numbers& numbers) {
  for (const auto& let : lets.elements_or_none(max_lets)) {
    const auto pair = let.elements();
    if (pair.size() != 2) return let.report("expected a name and a formula");
    const std::string name = pair[0].text(64);
    require_free_name(pair[0], name);
    if (numbers.scope()->values.count(name))
      pair[0].report("\"" + name + "\" is already the name of a parameter or let");
    if (numbers.failed()) return;
    Value value = numbers.value(pair[1]);
    if (numbers.failed()) return;
    numbers.scope()->values[name] = std::move(value);
  }
}

}  // namespace detail

Result<std::vector<Parameter>> describe_parameters(const Json& recipe, const std::string& source) {
  JsonReader::Problems problems(source);
  const JsonReader root(recipe, problems);
  if (!root.is_object()) root.report("expected a shape program, an object");
  if (problems.first()) return *problems.first();
  auto parameters = detail::read_parameters(root["parameters"]);
  if (problems.first()) return *problems.first();
  return parameters;
}

Value parameter_value(const Parameter& parameter, const std::string& text) {
  if (detail::wants_word(parameter)) return text;
  double number = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (code != std::errc() || end != text.data() + text.size()) return text;
  return number;
}

Values clamped(const std::vector<Parameter>& parameters, const Values& values) {
  Values result;
  for (const auto& parameter : parameters) {
    const auto given = values.find(parameter.name);
    if (given == values.end()) continue;
    Value value = given->second;
    if (auto* number = std::get_if<double>(&value); number && std::isfinite(*number)) {
      *number = std::clamp(*number, parameter.min, parameter.max);
      // Rounding may leave a range whose ends are not whole.
      if (parameter.integer)
        *number =
            std::clamp(std::round(*number), std::ceil(parameter.min), std::floor(parameter.max));
    }
    result[parameter.name] = detail::objection(parameter, value).empty() ? value : parameter.value;
  }
  return result;
}

}  // namespace roomgen::shape
