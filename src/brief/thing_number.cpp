#include <algorithm>
#include <cmath>
#include <optional>

#include "language/amount.h"
#include "language/number.h"
#include "thing_readers.h"

namespace roomgen::brief {

namespace {

using language::Determiner;

constexpr int max_count = 200;

class NumberReader : private PhraseWords {
 public:
  NumberReader(const PhraseWords& phrase, ThingPhrase& thing) : PhraseWords(phrase), thing_(thing) {}

  void run() {
    thing_.definite = said.determiner == Determiner::definite ||
                      said.determiner == Determiner::possessive ||
                      said.determiner == Determiner::each || said.determiner == Determiner::both;
    thing_.another = said.determiner == Determiner::another;
    thing_.article = thing_.another || said.determiner == Determiner::indefinite;
    qualifier();
    for (std::uint32_t i = said.tokens.begin; i < thing_.name_tokens.begin; ++i) count_word(i);
    range();
    spread();
    seats_behind();
    // Numbers of several words.
    const bool part_of_name = is_number(thing_.name_tokens.begin) || measured_;
    if (!thing_.article && said.count > 0 && !part_of_name) count_in_words();
    exclude_bound();
  }

 private:
  // "sixty", "two hundred"
  void count_in_words() {
    set_count(said.count, true);
    for (auto first = said.tokens.begin; first < thing_.name_tokens.begin; ++first)
      if (const auto number = language::number_at(parse.tokens, first); number && first + number->length <= thing_.name_tokens.begin) {
        for (auto i = first; i < first + number->length; ++i) thing_.count_tokens.push_back(i);
        return;
      }
  }
  // "8 to 12", "two or three", "about a dozen": what stands before the noun is a range.
  void range() {
    for (std::uint32_t first = said.tokens.begin; first < thing_.name_tokens.begin; ++first) {
      const auto amount = language::amount_at(parse.tokens, first);
      if (!amount || amount->is_share || first + amount->length > thing_.name_tokens.begin) continue;
      const auto [least, most] = language::counted_bounds(*amount);
      if (most > max_count || most <= least || least < 1.0) return;
      set_count(std::round(0.5 * (least + most)), true);
      thing_.least = static_cast<int>(least), thing_.most = static_cast<int>(most);
      for (auto i = first; i < first + amount->length; ++i) thing_.count_tokens.push_back(i);
      return;
    }
  }
  // "posters all over the walls", "plants everywhere": lots of them.
  void spread() {
    if (thing_.article || thing_.count_tokens.size() > 0 || said.determiner != Determiner::absent || said.count > 0) return;
    const auto behind = longest(text.words.spreads, text.plain, said.head + 1);
    if (!behind) return;
    set_count(*behind.value, false);
    if (behind.length == 1 && !text.words.placements.count(word(said.head + 1))) thing_.count_tokens.push_back(said.head + 1);
  }
  // "six tables for two"
  void seats_behind() {
    static const WordSet tables = {"table", "tables", "booth", "booths"};
    const bool is_said = said.head + 2 < parse.tokens.size() && word(said.head + 1) == "for";
    if (!is_said || !tables.count(word(said.head))) return;
    const auto number = language::number_at(parse.tokens, said.head + 2);
    const auto behind = said.head + 2 + static_cast<std::uint32_t>(number ? number->length : 0);
    const bool counts_things = behind < parse.tokens.size() && text.plain[behind].kind == Token::Kind::word &&
                               !text.words.stops.count(word(behind));
    if (!number || counts_things || number->value < 1.0 || number->value > 40.0) return;
    thing_.seats = static_cast<int>(number->value);
    for (auto i = said.head + 1; i < behind; ++i) thing_.count_tokens.push_back(i);
  }
  // "at least five", "exactly two", "no more than one"
  void qualifier() {
    static const WordSet words = {"least", "exactly", "only",  "more", "most",
                                  "just",  "than",    "fewer", "less", "precisely"};
    auto first = said.tokens.begin, end = first;
    while (said.tokens.begin - first < 3 && first > 0 && words.count(word(first - 1))) --first;
    while (end < thing_.name_tokens.begin && (words.count(word(end)) || word(end) == "at")) ++end;
    for (auto i = first; i < end; ++i) thing_.count_tokens.push_back(i);
    if (first < end) limit(first);
  }
  // "at", "no" may stand before the words that qualify.
  void limit(std::uint32_t first) {
    using Limit = language::Measure::Limit;
    const bool begins_before = first > 0 && language::bound_at(parse.tokens, first - 1).length > 0;
    if (begins_before) thing_.count_tokens.push_back(--first);
    const auto bound = language::bound_at(parse.tokens, first);
    thing_.at_least = bound.limit == Limit::least;
    thing_.at_most = bound.limit == Limit::most;
    bound_at_ = first;
  }
  // "fewer than five" are four at most, "more than three" at least four.
  void exclude_bound() {
    const auto amount = bound_at_ ? language::amount_at(parse.tokens, *bound_at_) : std::nullopt;
    if (!amount || amount->is_share || *bound_at_ + amount->length > thing_.name_tokens.begin) return;
    thing_.at_least = std::isinf(amount->high);
    thing_.at_most = amount->low == 0.0 && amount->high >= 1.0;
    if (thing_.at_least || thing_.at_most) set_count(thing_.at_least ? amount->low : amount->high, true);
  }

  void count_word(std::uint32_t token) {
    const std::string& here = word(token);
    static const WordSet sets = {"set", "pair", "group", "row", "collection", "series"};
    thing_.set = thing_.set || (sets.count(here) && token < thing_.name_tokens.begin);
    if (here == "own") thing_.count_tokens.push_back(token);
    if (text.words.further.count(here) && !is_modifier(token))
      add_modifier(thing_, here, {token, token + 1});
    if (is_measured(token, thing_)) {
      measured_ = true;
      const auto known = text.words.numbers.find(here);
      const int value = known != text.words.numbers.end()
                            ? known->second
                            : static_cast<int>(std::min(text.plain[token].value, 100.0));
      const std::string& what = word(token + 1);
      if (what == "seat" || what == "seater" || what == "person") thing_.seats = value;
      add_modifier(thing_, here + " " + what, {token, token + 2});
    } else if (text.plain[token].kind == Token::Kind::number) {
      thing_.count_tokens.push_back(token);
      if (said.measure == language::none)
        set_count(said.count, true);
    } else if (const auto value = text.words.numbers.find(here);
               value != text.words.numbers.end() && (!is_modifier(token) || value->second == 1)) {
      // "a dozen", "twenty-four": what the parse makes of the words counts.
      thing_.count_tokens.push_back(token);
      const bool exact = !text.words.vague.count(here);
      const double told = is_number(thing_.name_tokens.begin) ? 0.0 : said.count;
      set_count(exact && told >= 1.0 ? told : value->second, exact);
    }
  }
  void set_count(double value, bool exact) {
    thing_.count = static_cast<int>(std::clamp<double>(value, 1, max_count));
    thing_.beyond = value > max_count ? value : 0.0;
    thing_.counted = exact;
    thing_.article = true;
  }

  ThingPhrase& thing_;
  bool measured_ = false;
  std::optional<std::uint32_t> bound_at_;  ///< where words begin that bound the number
};

}  // namespace

void read_number(const PhraseWords& phrase, ThingPhrase& thing) { NumberReader(phrase, thing).run(); }

}  // namespace roomgen::brief
