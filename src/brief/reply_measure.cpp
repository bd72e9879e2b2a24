#include "reply_measure.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "language/small_words.h"
#include "prompt_words.h"
#include "roomgen/base/text.h"

namespace roomgen::brief {

namespace {

constexpr std::size_t max_text = 500;
constexpr std::size_t max_numbers = 16;
constexpr double greatest = 1e9;

struct Mark {
  std::string_view text;
  double metres;
};
constexpr Mark unit_marks[] = {
    {"'", 0.3048}, {"\"", 0.0254}, {"\u2032", 0.3048}, {"\u2033", 0.0254}};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Reads a text from left to right.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::vector<Measure> run() {
    std::string label;
    while (at_ < text_.size() && found_.size() < max_numbers) {
      if (starts_number()) {
        if (!number(label)) return {};
        label.clear();
      } else if (is_letter(text_[at_])) {
        label = word();
      } else if (calculates()) {
        return {};
      } else {
        ++at_;
      }
    }
    share_units();
    return found_;
  }

 private:
  bool digit_at(std::size_t at) const { return at < text_.size() && is_digit(text_[at]); }

  bool starts_number() const {
    if (digit_at(at_)) return true;
    const char c = text_[at_];
    if (c == '.') return digit_at(at_ + 1);
    if (c != '-' && c != '+') return false;
    const bool after_number = at_ > 0 && is_digit(text_[at_ - 1]);
    return !after_number && (digit_at(at_ + 1) || text_.substr(at_ + 1, 1) == ".");
  }

  // A sign that joins two numbers; "-" also begins items of lists.
  bool calculates() const {
    return !found_.empty() && std::string_view("+-*/").find(text_[at_]) != std::string_view::npos;
  }

  std::string word() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    return lower(text_.substr(begin, at_ - begin));
  }

  bool number(const std::string& label) {
    if (text_[at_] == '+') ++at_;
    double value = 0;
    const auto read = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value,
                                      std::chars_format::fixed);
    if (read.ec != std::errc{} || !(std::abs(value) < greatest)) return false;
    at_ = static_cast<std::size_t>(read.ptr - text_.data());
    const auto metres = unit();
    found_.push_back({value * metres.value_or(1.0), metres.has_value(), label});
    units_.push_back(metres.value_or(1.0));
    return true;
  }

  // "160 x 210 x 90 cm": the unit is that of the numbers before it, too.
  void share_units() {
    for (std::size_t i = found_.size(); i-- > 1;)
      if (found_[i].has_unit && !found_[i - 1].has_unit) {
        units_[i - 1] = units_[i];
        found_[i - 1].value *= units_[i];
        found_[i - 1].has_unit = true;
      }
  }

  std::optional<double> unit() {
    const std::size_t before = at_;
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    for (const auto& mark : unit_marks)
      if (text_.substr(at_).starts_with(mark.text)) {
        at_ += mark.text.size();
        return mark.metres;
      }
    const auto& units = language::small_words().lengths;
    const auto known = units.find(word());
    if (known != units.end()) return known->second;
    at_ = before;
    return std::nullopt;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<Measure> found_;
  std::vector<double> units_;  ///< of found_, in metres
};

// None if the text calculates ("4.2 - 0.5") instead of saying numbers.
std::vector<Measure> measures_in_text(const std::string& text) {
  if (text.size() > max_text) return {};
  return Scanner(text).run();
}

}  // namespace

std::vector<Measure> measures_in(const Json& value) {
  if (value.is_number()) {
    const double number = value.get<double>();
    if (!(std::abs(number) < greatest)) return {};
    return {{number, false, ""}};
  }
  if (value.is_string()) return measures_in_text(value.get_ref<const std::string&>());
  std::vector<Measure> all;
  if (!value.is_structured() || value.size() > max_numbers) return all;
  for (const auto& [key, element] : value.items()) {
    if (element.is_structured()) continue;
    auto measures = measures_in(element);
    if (value.is_object() && measures.size() == 1) {
      const auto names = words(key);
      measures[0].label = names.empty() ? "" : names.front();
    }
    all.insert(all.end(), measures.begin(), measures.end());
  }
  return all;
}

std::optional<Measure> single_measure(const Json& value) {
  const auto measures = measures_in(value);
  if (measures.size() != 1) return std::nullopt;
  return measures.front();
}

namespace {

struct SideWord {
  std::string_view word;
  int axis;
};
constexpr SideWord side_words[] = {{"width", 0},  {"w", 0},     {"x", 0}, {"length", 1},
                                   {"l", 1},      {"depth", 1}, {"d", 1}, {"y", 1},
                                   {"height", 2}, {"h", 2},     {"z", 2}, {"thickness", 1}};

}  // namespace

bool names_side(const Measure& measure) {
  return std::any_of(std::begin(side_words), std::end(side_words),
                     [&](const SideWord& side) { return side.word == measure.label; });
}

SaidSides sides_in(std::vector<Measure> measures) {
  SaidSides said;
  said.has_units = std::any_of(measures.begin(), measures.end(),
                               [](const Measure& one) { return one.has_unit; });
  for (const auto& measure : measures)
    for (const auto& side : side_words)
      if (measures.size() >= 2 && measure.label == side.word && measure.label != "x")
        said.sides[side.axis] = measure.value;
  if (!std::isnan(said.sides.x() + said.sides.y())) return said;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, measures.size()); ++i)
    said.sides[static_cast<int>(i)] = measures[i].value;
  return said;
}

std::optional<Vec3> size_in(const Json& value, const SizeForm& form) {
  const auto measures = measures_in(value);
  if (measures.size() != 3) return std::nullopt;
  SaidSides said = sides_in(measures);
  if (!said.has_units) said.sides *= form.unit;
  const bool is_size = said.sides.minCoeff() >= form.least && said.sides.maxCoeff() <= form.most;
  return is_size ? std::optional(said.sides) : std::nullopt;
}

std::optional<int> count_in(const Json& value) {
  if (value.is_string() && built_in_vocabulary()) {
    const auto& numbers = (*built_in_vocabulary()).numbers;
    for (const auto& word : words(value.get_ref<const std::string&>()))
      if (const auto known = numbers.find(word); known != numbers.end()) return known->second;
  }
  const auto measure = single_measure(value);
  if (!measure || std::abs(measure->value) > 1e6) return std::nullopt;
  return static_cast<int>(std::lround(measure->value));
}

}  // namespace roomgen::brief
