#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "design.h"
#include "laying.h"
#include "program_color.h"

namespace roomgen::book {

namespace {

// Members whose values are numbers, or lists of numbers: there a text is a formula.
const std::set<std::string, std::less<>> number_members = {
    "size_cm", "quantity", "gap_m",    "at_m",    "bottom_m", "lean_deg", "value",
    "rows",    "columns",  "across_m", "along_m", "at",       "along",    "width",
    "sill",    "head",     "height_m", "height",  "when",     "number",   "hour"};

Error wrong(const std::string& where, const std::string& what) {
  return {Error::Kind::invalid_input, where + ": " + what};
}

/// Puts numbers in the place of formulas and words in the place of the palette's roles.
class Filling {
 public:
  Filling(const Design& design, const Values& values, const Json& palette)
      : source_(design.source),
        scope_{values, {}, 0},
        palette_(palette),
        programs_(design.programs) {}

  std::optional<Error> first_error() const { return error_; }

  // `is_number`: it is the value of a number's member, or stands in its list.
  Json filled(const Json& json, const std::string& pointer, bool is_number) {
    if (json.is_string()) return is_number ? number(json, pointer) : Json(worded(json));
    if (!json.is_structured()) return json;
    Json result = json.is_array() ? Json::array() : Json::object();
    for (const auto& [key, value] : json.items()) {
      const std::string inner = pointer + "/" + key;
      if (json.is_array()) {
        if (is_there(value, inner)) result.push_back(filled(value, inner, is_number));
      } else if (key == "program") {
        result[key] = program(value, inner);
      } else if (key == "with" && value.is_object()) {
        result[key] = settings(value, inner);
      } else if (key != "when") {
        result[key] = filled(value, inner, number_members.count(key) > 0);
      }
    }
    return result;
  }

 private:
  bool is_there(const Json& value, const std::string& pointer) {
    if (!value.is_object() || !value.contains("when")) return true;
    const Json truth =
        value["when"].is_string() ? number(value["when"], pointer + "/when") : value["when"];
    return !truth.is_number() || truth.get<double>() != 0.0;
  }

  Json number(const Json& text, const std::string& pointer) {
    const auto formula = Expression::compile(text.get<std::string>());
    const auto value = formula ? formula->number(scope_) : Result<double>(formula.error());
    if (value) return *value;
    if (!error_) error_ = wrong(source_, pointer + ": " + value.error().message);
    return 0.0;
  }

  // A shape program, or the name of one of the design's.
  Json program(const Json& said, const std::string& pointer) {
    if (!said.is_string()) return only_worded(said, false);
    const auto known = programs_.find(said.get<std::string>());
    if (known != programs_.end()) return only_worded(*known, false);
    if (!error_)
      error_ =
          wrong(source_, pointer + ": \"" + said.get<std::string>() + "\" is none of \"programs\"");
    return Json();
  }

  // Programs have formulas of their own, and know fewer colours than people.
  Json only_worded(const Json& json, bool is_color) const {
    if (json.is_string()) return is_color ? program_color(worded(json)) : worded(json);
    if (!json.is_structured()) return json;
    Json result = json;
    for (const auto& [key, value] : json.items()) {
      Json inner = only_worded(value, key == "color");
      if (json.is_array())
        result[std::stoul(key)] = std::move(inner);
      else
        result[key] = std::move(inner);
    }
    return result;
  }

  // Choices of a composition are words.
  Json settings(const Json& with, const std::string&) {
    Json result = Json::object();
    for (const auto& [key, value] : with.items()) {
      const auto formula = value.is_string() ? Expression::compile(value.get<std::string>())
                                             : Result<Expression>(Error{});
      const auto number = formula ? formula->number(scope_) : Result<double>(Error{});
      result[key] = number ? Json(*number) : value;
    }
    return result;
  }

  std::string worded(const Json& json) const {
    std::string text = json.get<std::string>();
    for (std::size_t open = text.find('{'); open != std::string::npos;
         open = text.find('{', open)) {
      const std::size_t close = text.find('}', open);
      if (close == std::string::npos) break;
      const std::string role = text.substr(open + 1, close - open - 1);
      const std::string word =
          palette_.is_object() ? palette_.value(role, std::string()) : std::string();
      text.replace(open, close - open + 1, word);
      open += word.size();
    }
    return text;
  }

  std::string source_;
  shape::Scope scope_;
  const Json& palette_;
  const Json& programs_;
  std::optional<Error> error_;
};

}  // namespace

Result<Json> answer_of(const Design& design, const Setting& setting) {
  Vec2 size = setting.size;
  if (setting.turns % 2 != 0) std::swap(size.x(), size.y());
  Values values = setting.values;
  values["W"] = size.x(), values["D"] = size.y(), values["H"] = setting.height;
  Filling filling(design, values, setting.palette);
  Json body = setting.openings.is_array() ? design.body : Json();
  if (setting.openings.is_array()) body["openings"] = setting.openings;
  Json answer = filling.filled(setting.openings.is_array() ? body : design.body, "", false);
  if (const auto error = filling.first_error()) return *error;
  if (auto status = lay(design.source, setting, size, answer); !status) return status.error();
  Json& room = answer["room"];
  if (room.is_null()) room = Json::object();
  room["size_m"] = {setting.size.x(), setting.size.y()};
  room["palette"] = setting.palette.is_object() ? setting.palette : Json::object();
  return answer;
}

}  // namespace roomgen::book
