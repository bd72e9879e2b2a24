#include "roomgen/base/json.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>

#include "json_builder.h"
#include "json_reader.h"
#include "json_values.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr int max_depth = 64;
constexpr std::size_t most_remarks = 50;
constexpr std::size_t longest_quoted = 2000;  // bytes of a pointer or of a report, which may quote what the file says

// nlohmann's parser is not recursive, but whoever walks the value afterwards may be.
bool deeper_than(const std::string_view text, int limit) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      else if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > limit) return true;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

std::string line_and_column(std::string_view text, std::size_t byte) {
  const auto before = text.substr(0, std::min(byte, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const auto newline = before.rfind('\n');
  const auto column = before.size() - (newline == std::string_view::npos ? 0 : newline + 1);
  return "line " + std::to_string(line) + ", column " +
         std::to_string(std::max<std::size_t>(1, column));
}

bool is_plain(const Json& value) { return !value.is_structured(); }

// Arrays of plain values and of short such arrays ([[0,0],[4,0]]) stay on one line.
bool on_one_line(const Json& value) {
  if (!value.is_array()) return false;
  return std::all_of(value.begin(), value.end(), [](const Json& element) {
    return is_plain(element) ||
           (element.is_array() && std::all_of(element.begin(), element.end(), is_plain));
  });
}

void dump(const Json& value, int indent, std::string& out) {
  if (!value.is_structured() || value.empty() || on_one_line(value)) {
    out += json_line(value);
    return;
  }
  const std::string inner(static_cast<std::size_t>(indent) + 2, ' ');
  out += value.is_array() ? "[\n" : "{\n";
  bool first = true;
  for (const auto& [key, element] : value.items()) {
    if (!first) out += ",\n";
    first = false;
    out += inner;
    if (value.is_object())
      out += json_line(key) + ": ";
    dump(element, indent + 2, out);
  }
  out += "\n" + std::string(static_cast<std::size_t>(indent), ' ') + (value.is_array() ? "]" : "}");
}

std::string range(double low, double high) {
  return "from " + format_number(low, 6) + " to " + format_number(high, 6);
}

std::string below(const std::string& pointer, std::string_view key) {
  std::string result;
  result.reserve(pointer.size() + 1 + key.size());
  return result.append(pointer).append(1, '/').append(key);
}

}  // namespace

Result<Json> parse_json(std::string_view text, const std::string& source) {
  if (deeper_than(text, max_depth))
    return Error{Error::Kind::limit,
                 source + ": nested more than " + std::to_string(max_depth) + " deep"};
  detail::JsonBuilder builder;
  if (Json::sax_parse(text, &builder)) return builder.take();
  if (builder.fault() == detail::JsonBuilder::Fault::too_many)
    return Error{Error::Kind::limit, source + ": JSON of more than " +
                                         std::to_string(detail::JsonBuilder::most_values) + " values"};
  if (builder.fault() == detail::JsonBuilder::Fault::range)
    return Error{Error::Kind::invalid_input, source + ": JSON with a value out of range"};
  return Error{Error::Kind::invalid_input,
               source + ": not valid JSON at " + line_and_column(text, builder.fault_byte())};
}

Json json_literal(std::string_view text) {
  auto json = parse_json(text, "literal");
  assert(json);
  return *std::move(json);
}

std::string json_line(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string dump_json(const Json& value) {
  std::string out;
  dump(value, 0, out);
  return out + "\n";
}

double rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  const double result = std::round(value * scale) / scale;
  return result == 0.0 ? 0.0 : result;  // no "-0.0" in files
}

namespace {

std::string located(const std::string& pointer, const std::string& what) {
  const auto bounded = [](const std::string& text) {
    return text.size() <= longest_quoted ? text : shortened(text, longest_quoted) + "...";
  };
  return (pointer.empty() ? "" : bounded(pointer) + ": ") + bounded(what);
}

}  // namespace

void JsonReader::Problems::add(const std::string& pointer, const std::string& what) {
  if (!first_) first_ = Error{Error::Kind::invalid_input, source_ + ": " + located(pointer, what)};
}

void JsonReader::Problems::remark(const std::string& pointer, const std::string& what) {
  if (remarks_.size() < most_remarks) remarks_.push_back(located(pointer, what));
}

Status JsonReader::Problems::all() const {
  if (first_) return *first_;
  if (!remarks_.empty())
    return Error{Error::Kind::invalid_input, source_ + ": " + remarks_.front()};
  return {};
}

bool JsonReader::is_object() const { return value_ && value_->is_object(); }
bool JsonReader::is_array() const { return value_ && value_->is_array(); }
bool JsonReader::is_string() const { return value_ && value_->is_string(); }

JsonReader JsonReader::operator[](std::string_view key) const {
  std::string pointer = below(pointer_, key);
  if (!value_) return {nullptr, *problems_, std::move(pointer)};
  if (!value_->is_object()) {
    report("expected an object with the key \"" + std::string(key) + "\"");
    return {nullptr, *problems_, std::move(pointer)};
  }
  const auto& members = value_->get_ref<const Json::object_t&>();
  const auto found = std::find_if(members.begin(), members.end(), [&](const auto& one) { return one.first == key; });
  if (found == members.end() || found->second.is_null()) return {nullptr, *problems_, std::move(pointer)};
  return {&found->second, *problems_, std::move(pointer)};
}

std::vector<JsonReader> JsonReader::elements(std::size_t limit) const {
  std::vector<JsonReader> result;
  if (!value_ || !value_->is_array()) {
    report(value_ ? "expected an array" : "missing; expected an array");
    return result;
  }
  if (value_->size() > limit) {
    report("more than " + std::to_string(limit) + " elements");
    return result;
  }
  result.reserve(value_->size());
  for (std::size_t i = 0; i < value_->size(); ++i)
    result.push_back(JsonReader(&(*value_)[i], *problems_, below(pointer_, std::to_string(i))));
  return result;
}

std::vector<JsonReader> JsonReader::elements_or_none(std::size_t limit) const {
  if (!value_) return {};
  return elements(limit);
}

std::vector<std::pair<std::string, JsonReader>> JsonReader::members() const {
  std::vector<std::pair<std::string, JsonReader>> result;
  if (!value_) return result;
  if (!value_->is_object()) {
    report("expected an object");
    return result;
  }
  result.reserve(value_->size());
  for (const auto& [key, value] : value_->items())
    result.emplace_back(key, JsonReader(&value, *problems_, below(pointer_, key)));
  return result;
}

void JsonReader::allow_only(std::initializer_list<std::string_view> keys) const {
  if (!value_) return;
  if (!value_->is_object()) return report("expected an object");
  for (const auto& [key, value] : value_->items()) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    std::vector<std::string> known(keys.begin(), keys.end());
    const std::string close = closest_name(key, known);
    return report("unknown key \"" + key + "\"" +
                  (close.empty() ? "; known are " + join(known, ", ")
                                 : "; did you mean \"" + close + "\"?"));
  }
}

double JsonReader::number(double low, double high) const {
  if (!value_) {
    report("missing; expected a number " + range(low, high));
    return low;
  }
  return number_or(low, low, high);
}

double JsonReader::number_or(double fallback, double low, double high) const {
  if (!value_) return fallback;
  if (!value_->is_number()) {
    report("expected a number " + range(low, high));
    return fallback;
  }
  const double value = value_->get<double>();
  if (!(value >= low && value <= high)) {
    report(value_->dump() + " is out of range; expected a number " + range(low, high));
    return fallback;
  }
  return value;
}

long long JsonReader::integer_or(long long fallback, long long low, long long high) const {
  const double value =
      number_or(static_cast<double>(fallback), static_cast<double>(low), static_cast<double>(high));
  if (value != std::floor(value)) {
    report("expected a whole number");
    return fallback;
  }
  return static_cast<long long>(value);
}

bool JsonReader::boolean_or(bool fallback) const {
  if (!value_) return fallback;
  if (value_->is_boolean()) return value_->get<bool>();
  report("expected true or false");
  return fallback;
}

std::string JsonReader::text(std::size_t max_length) const {
  if (!value_) {
    report("missing; expected a text");
    return {};
  }
  return text_or({}, max_length);
}

std::string JsonReader::text_or(std::string fallback, std::size_t max_length) const {
  if (!value_) return fallback;
  if (!value_->is_string()) {
    report("expected a text");
    return fallback;
  }
  auto text = value_->get<std::string>();
  if (text.size() <= max_length) return text;
  report("longer than " + std::to_string(max_length) + " bytes");
  return fallback;
}

std::vector<double> JsonReader::numbers(std::size_t count, double low, double high) const {
  std::vector<double> result;
  if (!value_ || !value_->is_array() || value_->size() != count) {
    report("expected an array of " + std::to_string(count) + " numbers " + range(low, high));
    return std::vector<double>(count, low);
  }
  for (const auto& element : elements()) result.push_back(element.number(low, high));
  return result;
}

}  // namespace roomgen
