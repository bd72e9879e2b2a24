#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "base/resource.h"
#include "check_options.h"
#include "language/amount.h"
#include "language/inflection.h"
#include "language/measure.h"
#include "roomgen/base/text.h"
#include "roomgen/lab/tour.h"

namespace roomgen::lab {

namespace {

using language::Token;
using Tokens = std::span<const Token>;
using Phrases = std::vector<std::vector<std::string>>;

constexpr double birds_eye_height = 2.0, under_birds_ceiling = 0.3;
constexpr std::size_t longest_name = 4;  // words
constexpr std::size_t way_to_number = 3; // words between a phrase and its number: "eye height of about 1.2 m"

std::vector<std::string> token_texts(const std::string& text) {
  std::vector<std::string> texts;
  for (const auto& token : language::tokenize(text)) texts.push_back(token.text);
  return texts;
}

struct HiddenWord {
  std::vector<std::string> phrase;
  double least, most;
};

// data/tour.json
struct TourVocabulary {
  Json json;
  std::vector<HiddenWord> hidden_words;

  TourVocabulary() {
    const auto text = resource("data/tour.json");
    json = *parse_json(text.value_or("{}"), "data/tour.json");
    for (const auto& [phrase, range] : json["hidden words"].items())
      hidden_words.push_back({token_texts(phrase), range[0].get<double>(), range[1].get<double>()});
  }

  Phrases phrases(const char* key) const {
    Phrases list;
    for (const auto& phrase : json.at(key)) list.push_back(token_texts(phrase.get<std::string>()));
    return list;
  }
};

const TourVocabulary& vocabulary() {
  static const TourVocabulary words;
  return words;
}

bool phrase_at(Tokens tokens, std::size_t at, const std::vector<std::string>& phrase) {
  if (phrase.empty() || at + phrase.size() > tokens.size()) return false;
  for (std::size_t k = 0; k < phrase.size(); ++k)
    if (!tokens[at + k].is(phrase[k])) return false;
  return true;
}

// One past the first phrase of the list; nothing if there is none.
std::optional<std::size_t> behind_any(Tokens tokens, const Phrases& phrases) {
  for (std::size_t at = 0; at < tokens.size(); ++at)
    for (const auto& phrase : phrases)
      if (phrase_at(tokens, at, phrase)) return at + phrase.size();
  return std::nullopt;
}

bool has_any(Tokens tokens, const char* key) { return behind_any(tokens, vocabulary().phrases(key)).has_value(); }

std::vector<std::vector<Token>> sentences_of(std::string_view text) {
  std::vector<std::vector<Token>> sentences(1);
  for (auto& token : language::tokenize(text)) {
    if (token.kind == Token::Kind::stop)
      sentences.emplace_back();
    else
      sentences.back().push_back(std::move(token));
  }
  return sentences;
}

// The length that is said a few words behind, in metres.
std::optional<double> length_behind(Tokens tokens, std::size_t at) {
  for (std::size_t k = at; k < std::min(tokens.size(), at + way_to_number + 1); ++k)
    if (const auto measure = language::measure_at(tokens, k))
      if (measure->kind == language::Measure::Kind::length && measure->has_unit) return measure->values[0];
  return std::nullopt;
}

// Objects by what people call their kind.
class Mentions {
 public:
  Mentions(const Scene& scene, const KindTable& kinds) : scene_(scene), kinds_(kinds) {}

  /// Ids of all that the longest name at this token means, and how many words it has.
  std::vector<std::string> at(Tokens tokens, std::size_t at, std::size_t& length) const {
    for (length = std::min(longest_name, tokens.size() - at); length > 0; --length) {
      std::string name;
      for (std::size_t k = 0; k < length; ++k) name += (k ? " " : "") + tokens[at + k].text;
      if (auto ids = called(name); !ids.empty()) return ids;
    }
    length = 1;
    return {};
  }

 private:
  std::vector<std::string> called(const std::string& name) const {
    const Kind* kind = kinds_.called(name);
    const std::string one = language::singular(name);
    std::vector<std::string> ids;
    for (const auto& object : scene_.objects)
      if (object.category == one || object.id == name || (kind && kinds_.is_a(object.category, kind->name)))
        ids.push_back(object.id);
    // "the shelf" of a bookshelf
    for (const auto& object : scene_.objects)
      if (ids.empty() && one.size() > 3 && object.category.ends_with(one)) ids.push_back(object.id);
    return ids;
  }

  const Scene& scene_;
  const KindTable& kinds_;
};

class WordReader {
 public:
  WordReader(const Scene& scene, const KindTable& kinds, const TourOptions& options)
      : scene_(scene), mentions_(scene, kinds) {
    words_.options = options;
  }

  void read(std::string_view text, Tokens sentence) {
    if (sentence.empty() || !has_any(sentence, "camera")) return;
    const std::size_t before = words_.understood.size();
    read_birds_eye(sentence);
    read_height(sentence);
    read_angle(sentence);
    read_hidden(sentence);
    read_order(sentence);
    if (words_.understood.size() > before) return;
    const auto begin = sentence.front().span.begin, end = sentence.back().span.end;
    words_.not_understood.emplace_back(text.substr(begin, end - begin));
  }

  TourWords take() { return std::move(words_); }

 private:
  void understood(const std::string& what) { words_.understood.push_back(what); }

  void read_birds_eye(Tokens tokens) {
    if (!has_any(tokens, "birds eye")) return;
    words_.options = birds_eye(scene_, words_.options);
    understood("bird's-eye view");
  }

  void read_height(Tokens tokens) {
    const auto at = behind_any(tokens, vocabulary().phrases("eye height"));
    const auto metres = at ? length_behind(tokens, *at) : std::nullopt;
    if (!metres) return;
    words_.options.eye_height = *metres;
    understood("eye height " + format_number(*metres) + " m");
  }

  void read_angle(Tokens tokens) {
    const auto at = behind_any(tokens, vocabulary().phrases("field of view"));
    if (!at) return;
    for (std::size_t k = *at; k < std::min(tokens.size(), *at + way_to_number + 1); ++k) {
      if (tokens[k].kind != Token::Kind::number) continue;
      words_.options.field_of_view = radians(tokens[k].value);
      return understood("field of view " + format_number(tokens[k].value) + " degrees");
    }
  }

  void set_hidden(double least, double most) {
    words_.options.least_hidden = least;
    words_.options.greatest_hidden = most;
    understood("others hide " + format_number(100.0 * least, 1) + " to " + format_number(100.0 * most, 1) + " % of a target");
  }

  void read_hidden(Tokens tokens) {
    if (has_any(tokens, "hidden"))
      for (std::size_t at = 0; at < tokens.size(); ++at) {
        const auto amount = language::amount_at(tokens, at);
        if (!amount || !amount->is_share) continue;
        const double reach = amount->is_single() ? 0.1 : 0.0;
        return set_hidden(std::clamp(amount->low - reach, 0.0, 1.0), std::clamp(amount->high + reach, 0.0, 1.0));
      }
    for (std::size_t at = 0; at < tokens.size(); ++at)
      for (const auto& word : vocabulary().hidden_words)
        if (phrase_at(tokens, at, word.phrase)) return set_hidden(word.least, word.most);
  }

  enum class Turn { unsaid, first, last };

  // Part by part: "look at the bed first, then the desk, and the shelf last".
  void read_order(Tokens tokens) {
    Turn turn = Turn::unsaid;
    const Phrases separators = vocabulary().phrases("separators");
    for (std::size_t begin = 0; begin < tokens.size();) {
      std::size_t end = begin + 1;
      while (end < tokens.size() && tokens[end].kind != Token::Kind::comma &&
             std::none_of(separators.begin(), separators.end(), [&](const auto& p) { return phrase_at(tokens, end, p); }))
        ++end;
      read_part(tokens.subspan(begin, end - begin), turn);
      begin = end;
    }
  }

  void read_part(Tokens part, Turn& turn) {
    if (has_any(part, "last"))
      turn = Turn::last;
    else if (has_any(part, "first"))
      turn = Turn::first;
    else if (has_any(part, "then"))
      turn = turn == Turn::unsaid ? Turn::first : turn;
    else
      turn = Turn::unsaid;
    const bool only = has_any(part, "only");
    if (turn == Turn::unsaid && !only) return;
    for (std::size_t at = 0; at < part.size();) {
      std::size_t length = 1;
      const auto ids = mentions_.at(part, at, length);
      if (!ids.empty()) add(ids, only && turn == Turn::unsaid ? words_.options.targets
                                : turn == Turn::last          ? words_.options.last
                                                              : words_.options.first);
      at += length;
    }
  }

  void add(const std::vector<std::string>& ids, std::vector<std::string>& list) {
    for (const auto& id : ids)
      if (std::count(list.begin(), list.end(), id) == 0) list.push_back(id);
    const char* when = &list == &words_.options.last ? " last" : &list == &words_.options.first ? " first" : " only";
    understood(join(ids, ", ") + when);
  }

  const Scene& scene_;
  Mentions mentions_;
  TourWords words_;
};

}  // namespace

TourOptions birds_eye(const Scene& scene, TourOptions options) {
  options.flies = true;
  options.eye_height = std::min(birds_eye_height, detail::lowest_ceiling(scene) - under_birds_ceiling);
  options.steepest_pitch = radians(89.0);
  options.least_distance = 0.0;
  return options;
}

TourWords read_tour_words(std::string_view text, const Scene& scene, const KindTable& kinds,
                          const TourOptions& options) {
  WordReader reader(scene, kinds, options);
  for (const auto& sentence : sentences_of(text)) reader.read(text, sentence);
  return reader.take();
}

}  // namespace roomgen::lab
