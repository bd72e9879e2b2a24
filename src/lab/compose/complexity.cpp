#include "complexity.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "language/amount.h"

namespace roomgen::lab {

namespace {

using compose::ComplexityWords;
using language::Token;
using Tokens = std::span<const Token>;

constexpr double about_share = 0.05, exact_share = 0.03;
constexpr std::size_t longest_gap = 3, longest_phrase = 4, look_back = 2;

/// A measure that is said at some tokens: the first, and one past the last.
struct Said {
  Range range;
  std::size_t begin = 0, end = 0;
};

// How many tokens from `at` on are one of the phrases; the longest.
std::size_t phrase_at(const std::vector<std::string>& phrases, Tokens tokens, std::size_t at) {
  std::size_t best = 0;
  std::string text;
  for (std::size_t n = 0; n < longest_phrase && at + n < tokens.size() && tokens[at + n].kind == Token::Kind::word;
       ++n) {
    const bool is_joined = tokens[at + n].joint == Token::Joint::hyphen;
    text += (n == 0 ? "" : is_joined ? "-" : " ") + tokens[at + n].text;
    if (std::ranges::find(phrases, text) != phrases.end()) best = n + 1;
  }
  return best;
}

// The range of a number of things that was said as an amount.
Range counted(const language::Amount& amount) {
  const auto [low, high] = language::counted_bounds(amount);
  return {low, high};
}

// The range of a share; what is no share and no number below 1 is none.
std::optional<Range> shared(const language::Amount& amount) {
  const double last = std::isinf(amount.high) ? amount.low : amount.high;
  if (!amount.is_share && last > 1.0) return std::nullopt;
  if (amount.is_share && last > 1.0) return std::nullopt;
  const double margin = amount.is_about ? about_share : amount.is_single() ? exact_share : 0.0;
  return Range{std::max(0.0, amount.low - margin), amount.high + margin};
}

class Reader {
 public:
  Reader(Tokens tokens, const std::string& name, const ComplexityWords::Measure& measure)
      : tokens_(tokens), measure_(measure), is_share_(name == "occupancy") {}

  // The first that the text says; a later one only where there is none.
  std::optional<Said> read() const {
    for (std::size_t at = 0; at < tokens_.size(); ++at)
      if (const auto said = said_at(at); said && !is_denied(at)) return said;
    for (std::size_t at = 0; at < tokens_.size(); ++at)
      if (const auto said = word_at(at)) return said;
    return std::nullopt;
  }

 private:
  struct Step {
    std::size_t at = 0;
    std::optional<Range> range;
  };

  std::optional<Said> said_at(std::size_t at) const {
    std::optional<Said> best;
    for (const auto& pattern : measure_.patterns)
      if (const auto end = match(pattern, 0, {at, {}}); end && end->range && (!best || end->at > best->end))
        best = Said{*end->range, at, end->at};
    return best;
  }

  // Matches a pattern from one of its places on.
  std::optional<Step> match(const ComplexityWords::Pattern& pattern, std::size_t place, const Step& step) const {
    if (place == pattern.size()) return step;
    const auto& words = pattern[place];
    if (words.front() == "#") return match_amount(pattern, place, step);
    if (words.front() == "..") {
      for (std::size_t skip = 0; skip <= longest_gap; ++skip) {
        if (skip > 0 && !is_filler(step.at + skip - 1)) break;
        if (const auto end = match(pattern, place + 1, {step.at + skip, step.range})) return end;
      }
      return std::nullopt;
    }
    if (words.front().starts_with('!')) {
      const bool follows = step.at < tokens_.size() && "!" + tokens_[step.at].text == words.front();
      return follows ? std::nullopt : match(pattern, place + 1, step);
    }
    if (step.at >= tokens_.size() || std::ranges::find(words, tokens_[step.at].text) == words.end())
      return std::nullopt;
    return match(pattern, place + 1, {step.at + 1, step.range});
  }

  std::optional<Step> match_amount(const ComplexityWords::Pattern& pattern, std::size_t place, const Step& step) const {
    if (const auto amount = language::amount_at(tokens_, step.at)) {
      // "a two-seat sofa" is one thing.
      if (!is_share_ && is_joined(step.at + amount->length)) return std::nullopt;
      const auto range = is_share_          ? shared(*amount)
                         : amount->is_share ? std::nullopt
                                            : std::optional(counted(*amount));
      return range ? match(pattern, place + 1, {step.at + amount->length, range}) : std::nullopt;
    }
    for (const auto& [level, range] : measure_.levels) {
      const auto words = compose::complexity_words().level_words.find(level);
      if (words == compose::complexity_words().level_words.end()) continue;
      const std::size_t length = phrase_at(words->second, tokens_, step.at);
      if (length == 0) continue;
      if (const auto end = match(pattern, place + 1, {step.at + length, range})) return end;
    }
    return std::nullopt;
  }

  bool is_joined(std::size_t at) const {
    return at < tokens_.size() && tokens_[at].joint == Token::Joint::hyphen && tokens_[at].kind == Token::Kind::word;
  }

  // What may stand between an amount and its noun: words that are neither numbers nor links to other things.
  bool is_filler(std::size_t at) const {
    static const std::vector<std::string> links = {"with", "and",    "for", "on", "in", "at",
                                                   "by",   "around", "of",  "or", "to"};
    return at < tokens_.size() && tokens_[at].kind == Token::Kind::word && !language::amount_at(tokens_, at) &&
           std::ranges::find(links, tokens_[at].text) == links.end();
  }

  // "each table seats four" says nothing of the room.
  bool is_denied(std::size_t at) const {
    const auto& denied = compose::complexity_words().denied_by;
    for (std::size_t back = 1; back <= look_back && back <= at; ++back) {
      const Token& token = tokens_[at - back];
      if (token.kind != Token::Kind::word) return false;
      if (std::ranges::find(denied, token.text) != denied.end()) return true;
    }
    return false;
  }

  std::optional<Said> word_at(std::size_t at) const {
    std::optional<Said> best;
    for (const auto& [level, words] : measure_.words)
      if (const std::size_t length = phrase_at(words, tokens_, at); length > 0 && (!best || at + length > best->end))
        best = Said{measure_.levels.at(level), at, at + length};
    return best;
  }

  Tokens tokens_;
  const ComplexityWords::Measure& measure_;
  bool is_share_;
};

std::optional<Said> said_of(const std::string& name, Tokens tokens) {
  const auto& measures = compose::complexity_words().measures;
  const auto measure = measures.find(name);
  return measure == measures.end() ? std::nullopt : Reader(tokens, name, measure->second).read();
}

}  // namespace

const std::vector<ComplexityMeasure>& complexity_measures() {
  static const std::vector<ComplexityMeasure> measures = {{"objects", &Complexity::objects},
                                                          {"seats", &Complexity::seats},
                                                          {"shelves", &Complexity::shelves},
                                                          {"occupancy", &Complexity::occupancy}};
  return measures;
}

double most_of_measure(std::string_view measure) { return measure == "occupancy" ? 1.0 : 1e4; }

Complexity complexity_of(std::string_view text) {
  const auto tokens = language::tokenize(text);
  Complexity complexity;
  for (const auto& [name, range] : complexity_measures())
    if (const auto said = said_of(name, tokens)) complexity.*range = said->range;
  return complexity;
}

std::vector<compose::MeasureSpan> compose::complexity_spans(std::string_view text) {
  const auto tokens = language::tokenize(text);
  std::vector<MeasureSpan> spans;
  for (const auto& [name, range] : complexity_measures())
    if (const auto said = said_of(name, tokens))
      spans.push_back({name, {tokens[said->begin].span.begin, tokens[said->end - 1].span.end}});
  std::ranges::sort(spans, {}, [](const MeasureSpan& one) { return one.span.begin; });
  return spans;
}

Complexity overridden(Complexity asked, const Complexity& told) {
  for (const auto& [name, range] : complexity_measures())
    if (told.*range) asked.*range = told.*range;
  return asked;
}

}  // namespace roomgen::lab
