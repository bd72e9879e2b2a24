#include "relative_size.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "language/inflection.h"
#include "language/number.h"
#include "part_forms.h"
#include "roomgen/base/json.h"
#include "words.h"

namespace roomgen::create {

namespace {

constexpr const char* relative_sizes_path = "data/create/relative_sizes.json";
constexpr double not_said = std::numeric_limits<double>::quiet_NaN();
constexpr int most_people = 30;
constexpr std::size_t most_between = 4;  // words from "half" to "height"

struct Comparisons {
  WordMap<double> heights, beings, comparatives, multiples;
  WordMap<Vec3> sides;
  WordSet level_words, reaching_words, like, usual, people;
};

WordMap<double> read_numbers(const JsonReader& json) {
  WordMap<double> result;
  for (const auto& [word, value] : json.members()) result[word] = value.number(0.01, 10);
  return result;
}

WordSet read_list(const JsonReader& json) {
  WordSet result;
  for (const auto& element : json.elements()) result.insert(element.text());
  return result;
}

Comparisons read() {
  Comparisons result;
  const auto json = parse_json(resource(relative_sizes_path).value_or("{}"), relative_sizes_path);
  if (!json) return result;
  JsonReader::Problems problems{relative_sizes_path};
  const JsonReader root(*json, problems);
  result.heights = read_numbers(root["heights"]);
  result.beings = read_numbers(root["beings"]);
  result.comparatives = read_numbers(root["comparatives"]);
  result.multiples = read_numbers(root["multiples"]);
  for (const auto& [word, value] : root["sides"].members())
    if (const auto axes = value.numbers(3, 0, 1); axes.size() == 3)
      result.sides[word] = Vec3(axes[0], axes[1], axes[2]);
  result.level_words = read_list(root["level words"]);
  result.reaching_words = read_list(root["reaching words"]);
  result.like = read_list(root["like"]);
  result.usual = read_list(root["usual"]);
  result.people = read_list(root["people"]);
  return result;
}

const Comparisons& comparisons() {
  static const Comparisons all = read();
  return all;
}

template <typename T>
const T* look_up(const WordMap<T>& map, const std::string& word) {
  const auto found = map.find(word);
  return found == map.end() ? nullptr : &found->second;
}

class SizeReader {
 public:
  explicit SizeReader(const std::string& prompt) : tokens_(language::tokenize(prompt)) {}

  RelativeSize run() {
    for (std::size_t at = 0; at < tokens_.size(); ++at) {
      read_level(at);
      read_comparison(at);
      read_multiple(at);
      read_people(at);
    }
    return result_;
  }

 private:
  std::string word(std::size_t at) const {
    using Kind = language::Token::Kind;
    if (at >= tokens_.size()) return "";
    const Kind kind = tokens_[at].kind;
    return kind == Kind::word || kind == Kind::number ? tokens_[at].text : "";
  }
  bool is_article(std::size_t at) const {
    static const WordSet articles = {"a", "an", "the", "my", "your", "one"};
    return articles.count(word(at)) > 0;
  }

  std::optional<double> number_value(std::size_t at) const {
    const auto number = language::number_at(tokens_, at);
    return number ? std::optional(number->value) : std::nullopt;
  }

  static bool is_part(const std::string& word) {
    return built_in_parts() && built_in_parts()->labels.count(word) > 0;
  }

  // "a knee-high shelf" is about the shelf unless the shelf is all there is; so is "legs knee high".
  bool is_about_part(std::size_t from, std::size_t end) const {
    const bool before = from > 0 && is_part(word(from - 1));
    const bool has_owner = std::any_of(tokens_.begin(), tokens_.begin() + static_cast<std::ptrdiff_t>(from),
                                       [](const auto& token) { return token.text == "with" || token.text == "and"; });
    return (before || is_part(word(end))) && has_owner;
  }

  void set_height(double height, std::size_t from, std::size_t end) {
    if (!is_about_part(from, end)) result_.height = height;
  }

  // "knee high", "at waist height", "up to the hip".
  void read_level(std::size_t at) {
    const double* height = look_up(comparisons().heights, language::singular(word(at)));
    if (!height) return;
    if (comparisons().level_words.count(word(at + 1))) return set_height(*height, at, at + 2);
    std::size_t before = at;
    if (before > 0 && is_article(before - 1)) --before;
    const bool reaches = before < at && before > 1 && word(before - 1) == "to" &&
                         (word(before - 2) == "up" || word(before - 2) == "comes" || word(before - 2) == "reaches");
    if (reaches || (before < at && before > 0 && word(before - 1) == "reaches"))
      set_height(*height, before - 1, at + 1);
  }

  // "taller than a child", "as tall as a door", "the height of a man".
  void read_comparison(std::size_t at) {
    if (const double* share = look_up(comparisons().comparatives, word(at)); share && word(at + 1) == "than")
      set_being(at, at + 2, *share);
    if (word(at) == "as" && comparisons().like.count(word(at + 1)) && word(at + 2) == "as")
      set_being(at, at + 3, 1.0);
    if (word(at) == "height" && word(at + 1) == "of") set_being(at, at + 2, 1.0);
  }

  void set_being(std::size_t from, std::size_t at, double share) {
    if (is_article(at)) ++at;
    if (const double* height = look_up(comparisons().beings, language::singular(word(at))))
      set_height(share * *height, from, at + 1);
  }

  // "twice as wide", "half the normal height", "three times the usual size".
  void read_multiple(std::size_t at) {
    std::size_t next = at + 1;
    std::optional<double> times;
    if (const double* multiple = look_up(comparisons().multiples, word(at))) times = *multiple;
    else if (word(at + 1) == "times") times = number_value(at), ++next;
    if (!times || *times <= 0.0 || *times > 20.0) return;
    const Vec3* side = nullptr;
    for (const std::size_t end = next + most_between; next < end && !side; ++next) {
      side = look_up(comparisons().sides, word(next));
      if (!side && !goes_between(next)) return;
    }
    // "twice as tall as a chair" compares with something else.
    const bool against_other = word(next) == "as" && !comparisons().usual.count(word(next + 1)) && word(next + 1) != "it";
    if (!side || against_other || is_about_part(at, next)) return;
    if (const Vec3* other = word(next) == "as" ? look_up(comparisons().sides, word(next + 1)) : nullptr; other) return;
    for (int axis = 0; axis < 3; ++axis)
      if ((*side)[axis] > 0) result_.factor[axis] = *times;
  }

  bool goes_between(std::size_t at) const {
    const std::string text = word(at);
    return text == "as" || text == "its" || text == "of" || text == "in" || is_article(at) ||
           comparisons().usual.count(text);
  }

  // "for ten", "for 4 people", "a three-seater", "seats six".
  void read_people(std::size_t at) {
    const auto count = language::number_at(tokens_, at);
    if (!count || count->value < 1 || count->value > most_people || count->value != std::floor(count->value)) return;
    const std::string after = word(at + count->length);
    const bool named = comparisons().people.count(after) > 0;
    // The end of the phrase: "for ten bottles" is no number of people.
    const bool last = after.empty() || after == "with" || after == "and" || after == "in" || after == "made";
    const std::string before = at > 0 ? word(at - 1) : "";
    if (named ? !is_article(at) : last && (before == "for" || before == "seats" || before == "seating"))
      result_.people = static_cast<int>(count->value);
  }

  std::vector<language::Token> tokens_;
  RelativeSize result_;
};

}  // namespace

RelativeSize read_relative_size(const std::string& prompt) {
  return SizeReader(prompt).run();
}

std::optional<Vec3> said_size(const Description& description, const ShapeKind* kind) {
  // What stands beside the first thing of a sentence has its words in common with it.
  if (!description.relation.empty()) return description.size;
  const RelativeSize relative = read_relative_size(description.prompt);
  Vec3 size = description.size.value_or(Vec3::Constant(not_said));
  for (int axis = 0; axis < 3; ++axis)
    if (std::isnan(size[axis]) && relative.factor[axis] != 1.0 && kind)
      size[axis] = relative.factor[axis] * kind->size[axis];
  if (relative.height && std::isnan(size.z())) size.z() = *relative.height;
  if (size.array().isNaN().all()) return std::nullopt;
  return size;
}

}  // namespace roomgen::create
