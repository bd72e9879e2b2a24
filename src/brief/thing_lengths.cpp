#include <algorithm>

#include "thing_readers.h"

namespace roomgen::brief {

namespace {

using language::Run;

class LengthReader : private PhraseWords {
 public:
  LengthReader(const PhraseWords& phrase, ThingPhrase& thing) : PhraseWords(phrase), thing_(thing) {}

  void run() {
    add_measure_in({said.tokens.begin, said.tokens.end});
    measures_behind();
    for (const auto& verb : parse.verbs)
      if (verb.subject == number)
        verb.is_denied ? add_denied_measure(verb.tokens) : add_measure_in({verb.tokens.end, verb.tokens.end + 1});
  }

 private:
  // "that is not taller than 1.8 m": only what is denied with its bound tells a size.
  void add_denied_measure(const Run& verb) {
    for (auto i = verb.begin; i <= verb.end && i < text.plain.size(); ++i) {
      const auto measure = language::bounded_measure_at(parse.tokens, i);
      if (!measure || measure->limit == language::Measure::Limit::exact || !text.words.negations.count(word(i))) continue;
      thing_.measures.push_back(*measure);
      thing_.measure_tokens.push_back({i, i + static_cast<std::uint32_t>(measure->length)});
      return;
    }
  }
  // "a bookcase 2.4 m tall and 3 m long", "a desk, 180 x 90 cm": up to what is said of something else.
  void measures_behind() {
    std::uint32_t at = said.tokens.end;
    for (int n = 0; n < 3; ++n) {
      while (at < text.plain.size() &&
             (text.plain[at].kind == Token::Kind::comma || text.plain[at].is_word("and") ||
              text.plain[at].is_word("about")))
        ++at;
      const auto measure = language::bounded_measure_at(parse.tokens, at);
      if (!measure || !measure->has_unit) return;
      const auto end = at + static_cast<std::uint32_t>(measure->length);
      if (is_of_other(end - 1)) return;
      add_measure_in({at, at + 1});
      at = end;
    }
  }
  bool is_of_other(std::uint32_t token) const {
    return std::any_of(parse.phrases.begin(), parse.phrases.end(), [&](const auto& other) {
      return &other != &said && other.tokens.begin <= token && token < other.tokens.end &&
             other.head >= token;
    });
  }
  // "a no taller than 1.5 m wardrobe": the words that bound may stand before the phrase.
  std::uint32_t with_bound(std::uint32_t measure) const {
    constexpr std::uint32_t longest = 4;
    for (std::uint32_t n = longest; n > 0; --n)
      if (n <= measure && language::bound_at(parse.tokens, measure - n).length == n) return measure - n;
    return measure;
  }
  // "a shelf 1.5 m above the floor", "2 m from the wall": where it is, and no size; "1.2 m of aisle" is of something else.
  bool is_distance(std::size_t behind) const {
    // "2 m in front of the screen"
    const auto place = longest(text.words.placements, text.plain, behind);
    if (place && place.length >= 3 && !place.value->pronoun) return true;
    return behind < text.plain.size() && (text.words.distances.count(word(behind)) > 0 || text.plain[behind].is_word("of"));
  }
  // The first that begins there.
  void add_measure_in(const Run& run) {
    for (auto first = run.begin; first < std::min<std::size_t>(run.end, parse.tokens.size()); ++first) {
      const auto i = with_bound(first);
      const auto measure = language::bounded_measure_at(parse.tokens, i);
      if (!measure) continue;
      if (is_distance(i + measure->length)) return;
      thing_.measures.push_back(*measure);
      thing_.measure_tokens.push_back({i, i + static_cast<std::uint32_t>(measure->length)});
      return;
    }
  }

  ThingPhrase& thing_;
};

}  // namespace

void read_lengths(const PhraseWords& phrase, ThingPhrase& thing) { LengthReader(phrase, thing).run(); }

}  // namespace roomgen::brief
