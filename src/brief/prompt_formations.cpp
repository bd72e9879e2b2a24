#include <algorithm>
#include <utility>

#include "language/number.h"
#include "mention_shape.h"
#include "prompt_passes.h"

namespace roomgen::brief {

namespace {

using language::Run;

/// "two rows of four": the words, and what they say.
struct SaidFormation {
  Formation formation;
  Run tokens;
  bool in_front = false;  ///< "two rows of desks", said before the things
  int number = 0;         ///< "a circle of six chairs"; 0: not said
  int only = 0;           ///< the number of things that can stand so; 0: any
};

class FormationReader {
 public:
  explicit FormationReader(PromptReading& reading) : reading_(reading) {}

  void run() {
    for (std::uint32_t i = 0; i < reading_.text.plain.size(); ++i) {
      const auto read = said_at(i);
      if (!read) continue;
      const SaidFormation& said = *read;
      if (const auto mention = said.in_front ? things_behind(said) : things_before(said))
        form(*mention, said);
    }
  }

 private:
  static constexpr int most_rows = 40;

  std::optional<SaidFormation> said_at(std::uint32_t at) const {
    if (reading_.taken[at] != Taken::no) return std::nullopt;
    if (reading_.words.rows.count(reading_.word(at))) return formation_at(at);
    const auto round = longest(reading_.words.round_formations, reading_.text.plain, at);
    return round ? round_formation(*round.value, {at, at + static_cast<std::uint32_t>(round.length)}) : std::nullopt;
  }
  // "in a wide circle", "a horseshoe of chairs", "forming a half circle"; a circle alone may be a thing, and so may "a
  // ring light".
  std::optional<SaidFormation> round_formation(const FormationWord& meant, const Run& words) const {
    SaidFormation said{{.rows = 0, .columns = 0, .shape = meant.shape}, words};
    const bool are_islands = meant.shape == Formation::Shape::islands;
    (are_islands ? said.formation.columns : said.only) = meant.number;
    for (int n = 0; n < 2 && describes_formation(said.tokens.begin); ++n) --said.tokens.begin;
    take_word_before(said, {"a", "an", "one", "the"});
    const auto first = said.tokens.begin;
    take_word_before(said, forming());
    bool is_led = said.tokens.begin < first && !phrase_over(words.end) && !describes_something(words.end - 1);
    // "four islands of six desks"
    const auto [islands, length] = are_islands ? number_before(words.begin) : std::pair<int, std::uint32_t>{0, 0};
    if (islands > 0 && reading_.is_word(words.end, "of")) said.tokens.begin = words.begin - length, is_led = true;
    if (reading_.is_word(words.end, "of")) {
      read_size(words.end + 1, said);
      if (!are_islands) std::swap(said.formation.columns, said.number);
      said.number = are_islands ? islands * said.formation.columns : said.number;
    }
    return is_led || said.in_front ? std::optional(said) : std::nullopt;
  }
  // "a wide circle", "one big ring"
  bool describes_formation(std::uint32_t end) const {
    static const WordSet ways = {"loose", "tight", "close", "neat", "perfect", "gentle", "open", "shallow", "full", "complete", "single"};
    return end > 0 && (ways.count(reading_.word(end - 1)) || reading_.words.sizes.count(reading_.word(end - 1)));
  }
  // "in a square alcove", but not "in a circle formation"
  bool describes_something(std::uint32_t token) const {
    static const WordSet figures = {"formation", "arrangement", "pattern", "shape", "layout", "configuration"};
    return std::any_of(reading_.parse.phrases.begin(), reading_.parse.phrases.end(), [&](const auto& phrase) {
      return phrase.tokens.begin <= token && token < phrase.head && !figures.count(reading_.word(phrase.head));
    });
  }
  static const WordSet& forming() {
    static const WordSet words = {"in", "into", "as", "by", "form", "forms", "forming", "make", "makes", "making"};
    return words;
  }

  // The number that ends right before a token, and how many tokens it has.
  std::pair<int, std::uint32_t> number_before(std::uint32_t token) const {
    for (std::uint32_t n = 3; n > 0; --n) {
      if (n > token) continue;
      const auto number = language::number_at(reading_.parse.tokens, token - n);
      if (number && number->length == n && number->value >= 1.0 && number->value <= most_rows)
        return {static_cast<int>(number->value), n};
    }
    return {0, 0};
  }

  SaidFormation formation_at(std::uint32_t at) const {
    SaidFormation said;
    const bool is_plural = reading_.word(at).ends_with('s');
    const auto [number, length] = number_before(at);
    said.tokens = {at - length, at + 1};
    if (const auto first = said.tokens.begin; length > 0 && first > 1 &&
        (reading_.is_word(first - 1, "by") || reading_.is_word(first - 1, "x"))) {
      // "a 3 by 4 grid"
      const auto [rows, rows_length] = number_before(first - 1);
      said.formation = {std::max(1, rows), number};
      said.tokens.begin = first - 1 - rows_length;
    } else {
      said.formation.rows = is_plural ? number : 1;
    }
    take_word_before(said, {"a", "one"});
    if (reading_.is_word(at + 1, "of")) read_size(at + 2, said);
    take_word_before(said, {"in"});
    // "in two columns": rows of two
    if (reading_.word(at).starts_with("column")) std::swap(said.formation.rows, said.formation.columns);
    return said;
  }
  void take_word_before(SaidFormation& said, const WordSet& words) const {
    if (said.tokens.begin > 0 && words.count(reading_.word(said.tokens.begin - 1))) --said.tokens.begin;
  }
  // "of four", which may go on: "of four desks".
  void read_size(std::uint32_t at, SaidFormation& said) const {
    const auto number = language::number_at(reading_.parse.tokens, at);
    const auto end = at + static_cast<std::uint32_t>(number ? number->length : 0);
    if (number && number->value >= 1.0 && number->value <= most_rows) {
      said.formation.columns = static_cast<int>(number->value);
      said.tokens.end = end;
      if (read_second_size(end, said)) return;
    }
    said.in_front = phrase_over(end).has_value();
  }
  // "a grid of three by four"
  bool read_second_size(std::uint32_t at, SaidFormation& said) const {
    if (!reading_.is_word(at, "by") && !reading_.is_word(at, "x")) return false;
    const auto number = language::number_at(reading_.parse.tokens, at + 1);
    if (!number || number->value < 1.0 || number->value > most_rows) return false;
    said.formation.rows = std::exchange(said.formation.columns, static_cast<int>(number->value));
    said.tokens.end = at + 1 + static_cast<std::uint32_t>(number->length);
    return true;
  }
  // The phrase that names things and goes on over a token.
  std::optional<std::size_t> phrase_over(std::uint32_t token) const {
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) {
      const auto& phrase = reading_.parse.phrases[i];
      if (phrase.tokens.begin <= token && token <= phrase.head && reading_.mentions[i]) return i;
    }
    return std::nullopt;
  }
  std::optional<std::size_t> things_behind(const SaidFormation& said) const {
    const bool is_counted = said.formation.columns > 0 || said.number > 0;
    const auto phrase = phrase_over(said.tokens.end + (is_counted ? 0 : 1));
    return phrase ? reading_.mentions[*phrase] : std::nullopt;
  }
  // The last ones before it that may be several, in the same sentence or before its colon; else
  // those that it is said before: "In a row stand three stools".
  std::optional<std::size_t> things_before(const SaidFormation& said) const {
    std::optional<std::size_t> before, behind;
    const int sentence = reading_.sentence_of(said.tokens.begin);
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) {
      const auto mention = reading_.mentions[i];
      const auto head = reading_.parse.phrases[i].head;
      if (!mention || !are_several(*mention, said.formation)) continue;
      const int own = reading_.sentence_of(head);
      const bool announced =
          own + 1 == sentence &&
          reading_.announces(reading_.parse.sentences[static_cast<std::size_t>(own)]);
      if (head < said.tokens.begin && (own == sentence || announced)) before = mention;
      if (head >= said.tokens.end && own == sentence && !behind) behind = mention;
    }
    const auto nearest = before ? before : behind;
    return nearest && may_stand_in_rows(*nearest, said.formation) ? nearest : std::nullopt;
  }
  bool are_several(std::size_t mention, const Formation& formation) const {
    const Mention& things = reading_.talk.mention(mention);
    return things.quantity != 1 || (!things.counted && formation.rows * formation.columns > 1);
  }
  // Small things on others, and pictures on a wall, have no places of their own on the floor.
  bool may_stand_in_rows(std::size_t mention, const Formation& formation) const {
    const Mention& things = reading_.talk.mention(mention);
    if (!are_several(mention, formation)) return false;
    if (formation.is_round() && may_lie_on_floor(things)) return true;
    return !reading_.talk.is_small(mention) && things.mount == Mount::floor;
  }
  // "cushions in a circle": nothing carries them.
  bool may_lie_on_floor(const Mention& things) const {
    return things.mount == Mount::surface && reading_.text.table.by_name("floor " + things.noun);
  }

  void form(std::size_t index, const SaidFormation& said) {
    Mention& mention = reading_.brief.mentions[index];
    if (!may_stand_in_rows(index, said.formation) || mention.formation) return;
    const bool are_islands = said.formation.shape == Formation::Shape::islands;
    const int all = said.formation.is_round() || are_islands ? said.number : said.formation.rows * said.formation.columns;
    // "three rows of five seats": five are said, fifteen meant.
    if (all > 0 && (!mention.counted || mention.quantity == said.formation.columns))
      reading_.talk.set_count(index, all);
    if (said.only > 0 && !mention.counted) reading_.talk.set_count(index, said.only);
    if (said.only > 0 && mention.quantity != said.only) return;
    mention.formation = said.formation;
    if (may_lie_on_floor(mention)) hang(mention, Mount::floor, reading_.text.table);
    if (said.formation.is_round()) bound_table(mention);
    if (said.formation.is_round()) let_stand_in(said.tokens, index);
    mention.formation_heard = hear(reading_.brief, said.tokens, Heard::As::relation);
  }

  // Tables that are put together in a horseshoe are not each one for ten.
  void bound_table(Mention& mention) const {
    constexpr double longest = 1.4, deepest = 0.7;  ///< metres
    if (mention.sized || !reading_.text.table.is_a(mention.category, "table")) return;
    mention.size.x() = std::min(mention.size.x(), longest), mention.size.y() = std::min(mention.size.y(), deepest);
    mention.sized = true;
  }
  // "in a circle around the rug": what is said of the circle, is said of the things.
  void let_stand_in(const Run& tokens, std::size_t index) {
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i)
      if (const auto head = reading_.parse.phrases[i].head; tokens.begin <= head && head < tokens.end && !reading_.mentions[i])
        reading_.mentions[i] = index;
  }

  PromptReading& reading_;
};

}  // namespace

void read_formations(PromptReading& reading) { FormationReader(reading).run(); }

}  // namespace roomgen::brief
