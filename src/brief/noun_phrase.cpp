#include "noun_phrase.h"

#include <algorithm>

namespace roomgen::design {

namespace {

constexpr std::size_t max_modifiers = 8;
constexpr int max_count = 200;
constexpr std::size_t most_contents = 2;  ///< words

class NounPhraseReader {
 public:
  NounPhraseReader(std::span<const Token> tokens, std::size_t at, const Vocabulary& words,
         const KindTable& table)
      : tokens_(tokens), at_(at), words_(words), table_(table) {
    phrase_.begin = at;
  }

  std::optional<NounPhrase> run(bool may_be_unknown) {
    read_determiners();
    if (read_modifiers_and_head() && !bare_material()) {
      read_contents();
      pair_is_one();
      phrase_.end = at_;
      return phrase_;
    }
    if (may_be_unknown && phrase_.article && read_unknown()) return phrase_;
    return std::nullopt;
  }

 private:
  bool ended(std::size_t i) const { return i >= tokens_.size(); }
  const Token& token(std::size_t i) const { return tokens_[i]; }
  bool is_word(std::size_t i, std::string_view word) const {
    return !ended(i) && tokens_[i].is_word(word);
  }

  // "two seat sofa" and "stack of books" are names, whatever their words mean elsewhere.
  bool name_here() const { return mention_at(table_, tokens_, at_).length > 1; }

  void read_determiners() {
    while (!ended(at_) && !name_here()) {
      if (token(at_).kind == Token::Kind::number) {
        if (measured_follows()) return;
        count(static_cast<int>(std::min<double>(token(at_).value, max_count)), true);
      } else if (token(at_).kind != Token::Kind::word) {
        return;
      } else if (words_.definite.count(token(at_).text)) {
        phrase_.definite = true;
      } else if (!read_quantity_word()) {
        return;
      }
      ++at_;
      if (is_word(at_, "of") && phrase_.article) ++at_;
    }
  }

  bool read_quantity_word() {
    const std::string& word = token(at_).text;
    if (word == "set" || word == "group" || word == "row" || word == "collection" ||
        word == "series") {
      if (!is_word(at_ + 1, "of")) return false;
      phrase_.set = true;
      if (!phrase_.counted || phrase_.count == 1) {
        phrase_.count = std::max(phrase_.count, 2);
        phrase_.counted = false;
      }
      return true;
    }
    const auto found = words_.numbers.find(word);
    if (found == words_.numbers.end() || measured_follows()) return false;
    if ((word == "pair" || word == "couple" || word == "lots") && !is_word(at_ + 1, "of"))
      return false;
    phrase_.set = phrase_.set || word == "pair";
    phrase_.another = phrase_.another || word == "another";
    count(found->second, !words_.vague.count(word));
    return true;
  }

  void count(int number, bool exact) {
    // "a set of four", "the two": the later number counts.
    phrase_.count = std::clamp(number, 1, max_count);
    phrase_.counted = exact;
    phrase_.article = true;
  }

  // "three-drawer", "six-seater": no count of things.
  bool measured_follows() const {
    return !ended(at_ + 1) && token(at_ + 1).kind == Token::Kind::word &&
           words_.measured.count(token(at_ + 1).text) &&
           (ended(at_ + 2) || token(at_ + 2).kind == Token::Kind::word);
  }

  bool read_modifiers_and_head() {
    for (std::size_t n = 0; n < max_modifiers && !ended(at_); ++n) {
      if (read_head()) return true;
      const Token& here = token(at_);
      if (here.kind == Token::Kind::length) {
        phrase_.lengths.push_back(here);
        ++at_;
      } else if (read_measured()) {
        continue;
      } else if (joins_modifiers() || is_adverb()) {
        ++at_;
      } else if (is_way_of_standing()) {
        phrase_.modifiers.push_back(here.text);
        phrase_.modifiers.push_back(token(at_ + 1).text);
        at_ += 2;
      } else if (here.is_word("built") && is_word(at_ + 1, "in")) {
        phrase_.modifiers.push_back("built in");
        at_ += 2;
      } else if (here.kind != Token::Kind::word || words_.stops.count(here.text) ||
                 words_.negations.count(here.text) || words_.definite.count(here.text) ||
                 words_.numbers.count(here.text)) {
        return false;
      } else {
        phrase_.modifiers.push_back(here.text);
        ++at_;
      }
    }
    return !ended(at_) && read_head();
  }

  bool read_measured() {
    const auto number = [&]() -> int {
      if (token(at_).kind == Token::Kind::number)
        return static_cast<int>(std::min(token(at_).value, 100.0));
      const auto found = words_.numbers.find(token(at_).text);
      return found == words_.numbers.end() ? 0 : found->second;
    }();
    if (number == 0 || !measured_follows()) return false;
    const std::string& what = token(at_ + 1).text;
    if (what == "seat" || what == "seater" || what == "person") phrase_.seats = number;
    phrase_.modifiers.push_back(token(at_).text + " " + what);
    at_ += 2;
    return true;
  }

  // "a large, soft sofa", "a red and white rug": between modifiers, before the head.
  bool joins_modifiers() const {
    const Token& here = token(at_);
    if (here.kind != Token::Kind::comma && !here.is_word("and")) return false;
    if (phrase_.modifiers.empty() || ended(at_ + 1) || token(at_ + 1).kind != Token::Kind::word)
      return false;
    const std::string& next = token(at_ + 1).text;
    return !words_.stops.count(next) && !words_.numbers.count(next) && !words_.definite.count(next);
  }

  // "a wall-mounted shelf", "a floor-standing speaker", but no "shelf on the wall mounted above"
  bool is_way_of_standing() const {
    static const WordSet where = {"wall", "ceiling", "floor", "free"};
    static const WordSet how = {"mounted", "standing", "hung"};
    return where.count(token(at_).text) && !ended(at_ + 2) && how.count(token(at_ + 1).text) &&
           token(at_ + 2).kind != Token::Kind::comma && !words_.stops.count(token(at_ + 2).text) &&
           !words_.placements.count(token(at_ + 2).text);
  }

  // "a neatly folded towel"
  bool is_adverb() const {
    return phrase_.article && token(at_).kind == Token::Kind::word && token(at_).text.size() > 4 &&
           token(at_).text.ends_with("ly") && mention_at(table_, tokens_, at_).length == 0 &&
           !ended(at_ + 1) && token(at_ + 1).kind == Token::Kind::word &&
           words_.stops.count(token(at_).text) > 0;
  }

  // The head, which in a compound is the last noun: "bedside table lamp".
  bool read_head() {
    KindMention head = mention_at(table_, tokens_, at_);
    if (is_clause(head)) head = mention_at(table_, tokens_.first(at_ + head.length - 1), at_);
    if (head.length == 0) return false;
    if (head.length == 1 &&
        (words_.stops.count(token(at_).text) || is_brightness() || is_verb(at_)))
      return false;
    std::size_t start = at_;
    for (bool further = true; further;) {
      further = false;
      for (std::size_t k = start + 1; k <= start + head.length && !further; ++k) {
        if (ended(k)) break;
        const bool adjacent = k == start + head.length;
        if (adjacent && !phrase_.article && !phrase_.definite &&
            !words_.materials.count(token(start).text))
          break;
        if (is_verb(k)) break;
        const KindMention next = mention_at(table_, tokens_, k);
        if (next.length == 0 || k + next.length <= start + head.length) continue;
        for (std::size_t i = start; i < k; ++i) phrase_.modifiers.push_back(token(i).text);
        start = k;
        head = next;
        further = true;
      }
    }
    phrase_.kind = head;
    at_ = start + head.length;
    return true;
  }

  // "a plant stands near the window" is about a plant, no plant stand.
  bool is_clause(const KindMention& head) const {
    return head.plural && head.length > 1 && phrase_.article && phrase_.count == 1 &&
           words_.verbs.count(token(at_ + head.length - 1).text) > 0;
  }

  // "a bookshelf displays two vases"
  bool is_verb(std::size_t i) const {
    const auto placement = words_.placements.find(token(i).text);
    const bool places = placement != words_.placements.end() && placement->second.inverse;
    if ((!places && !words_.verbs.count(token(i).text)) || ended(i + 1)) return false;
    const Token& next = token(i + 1);
    return next.kind == Token::Kind::number || words_.numbers.count(next.text) ||
           words_.definite.count(next.text);
  }

  // "light grey linen", "soft light filters through": no lamp.
  bool is_brightness() const {
    if (!is_word(at_, "light")) return false;
    if (!phrase_.article && !phrase_.definite) return true;
    return !ended(at_ + 1) && token(at_ + 1).kind == Token::Kind::word &&
           !words_.stops.count(token(at_ + 1).text) && !words_.verbs.count(token(at_ + 1).text);
  }

  // "a jar of honey": bare nouns say what is in it, and are no things beside it.
  void read_contents() {
    if (!is_word(at_, "of") || phrase_.kind.plural || !phrase_.article) return;
    std::size_t end = at_ + 1;
    while (!ended(end) && end <= at_ + most_contents && is_content(token(end))) ++end;
    if (end == at_ + 1) return;
    phrase_.contents = "of";
    for (std::size_t i = at_ + 1; i < end; ++i) phrase_.contents += " " + token(i).text;
    at_ = end;
  }

  bool is_content(const Token& word) const {
    return word.kind == Token::Kind::word && !words_.stops.count(word.text) &&
           !words_.definite.count(word.text) && !words_.numbers.count(word.text) &&
           !words_.pronouns.count(word.text) && !words_.room_parts.count(word.text);
  }

  // "headphones", "a pair of scissors"
  void pair_is_one() {
    if (!words_.pairs.count(token(at_ - 1).text)) return;
    phrase_.kind.plural = false;
    if (phrase_.set || !phrase_.counted) phrase_.count = 1;
    phrase_.article = true;
  }

  // "glass" alone, without an article, is what something is made of.
  bool bare_material() const {
    return !phrase_.article && !phrase_.definite && phrase_.kind.length == 1 &&
           !phrase_.kind.plural && words_.materials.count(phrase_.kind.name) > 0;
  }

  // Back to the first modifier: the last word before a stop is the noun.
  bool read_unknown() {
    if (phrase_.modifiers.empty() || !phrase_.lengths.empty()) return false;
    if (!ended(at_) && token(at_).kind == Token::Kind::room) return false;
    const std::string noun = phrase_.modifiers.back();
    if (noun.size() < 3 || words_.no_things.count(noun) || words_.parts.count(noun) ||
        words_.sizes.count(noun) || words_.room_words.count(noun) ||
        words_.people_words.count(noun) || words_.stops.count(noun) || words_.verbs.count(noun))
      return false;
    phrase_.noun = noun;
    phrase_.modifiers.pop_back();
    phrase_.end = at_;
    return true;
  }

  std::span<const Token> tokens_;
  std::size_t at_;
  const Vocabulary& words_;
  const KindTable& table_;
  NounPhrase phrase_;
};

}  // namespace

std::optional<NounPhrase> read_noun_phrase(std::span<const Token> tokens, std::size_t at,
                                           const Vocabulary& words, const KindTable& table,
                                           bool may_be_unknown) {
  if (at >= tokens.size()) return std::nullopt;
  return NounPhraseReader(tokens, at, words, table).run(may_be_unknown);
}

}  // namespace roomgen::design
