#include "chunks.h"

#include <algorithm>

#include "small_words.h"

namespace roomgen::language {

namespace {

constexpr double most_counted = 1e6;  ///< things are no more, so that who counts them on may use whole numbers

class Chunker {
 public:
  Chunker(const std::vector<Piece>& pieces, Parse& parse) : pieces_(pieces), parse_(parse) {}

  std::vector<Chunk> run() {
    while (at_ < pieces_.size())
      if (!noun_phrase()) other();
    return std::move(chunks_);
  }

 private:
  static bool is_modifier(Tag tag) {
    return tag == Tag::adjective || tag == Tag::participle || tag == Tag::owner ||
           tag == Tag::adverb || tag == Tag::measure || tag == Tag::number;
  }
  bool is_modifier_at(std::size_t at) const {
    return at < pieces_.size() && is_modifier(pieces_[at].tag) && !pieces_[at].is_clause;
  }
  Tag tag_at(std::size_t at) const { return at < pieces_.size() ? pieces_[at].tag : Tag::stop; }

  // Where the noun phrase that begins at `at_` ends, and where its head is; the end is `at_` if
  // none begins there. "a black and white rug" goes on behind the conjunction.
  struct Extent {
    std::size_t head = 0, end = 0;
    bool has_noun = false;
  };

  Extent extent() const {
    Extent extent{at_, at_};
    const std::size_t last = at_ + longest_phrase;
    std::size_t i = at_;
    if (tag_at(i) == Tag::pronoun && !denies_noun(i)) return {i, i + 1, true};
    if (tag_at(i) == Tag::pronoun) ++i;
    while (tag_at(i) == Tag::determiner && i < last) ++i;
    if (tag_at(i) == Tag::pronoun && i > at_) {
      // "the other two"
      const std::size_t head = tag_at(i + 1) == Tag::number && tag_at(i + 2) != Tag::noun ? i + 1 : i;
      return {head, head + 1, true};
    }
    const std::size_t first = i;
    while (i < last && (is_modifier_at(i) || tag_at(i) == Tag::noun || joins_modifiers(i))) {
      // An owner begins what it owns anew: nouns before it are part of its name.
      if (tag_at(i) == Tag::noun) extent.head = i, extent.has_noun = true;
      if (extent.has_noun &&
          (tag_at(i) == Tag::number || tag_at(i) == Tag::measure || tag_at(i) == Tag::adverb))
        break;
      if (extent.has_noun && tag_at(i) == Tag::participle) break;
      if (extent.has_noun && tag_at(i) == Tag::adjective && tag_at(i + 1) == Tag::noun &&
          tag_at(i - 1) != Tag::noun)
        break;
      ++i;
    }
    while (i > first && tag_at(i - 1) == Tag::adverb) --i;
    extent.end = i;
    if (!extent.has_noun && !stands_for_noun(first, i, extent.head)) extent.end = at_;
    return extent;
  }

  // "nothing leather"
  bool denies_noun(std::size_t i) const {
    return small_words().negative_pronouns.count(parse_.tokens[pieces_[i].tokens.begin].text) > 0 && tag_at(i + 1) == Tag::noun;
  }

  // "the larger", "two", "the other": no noun, but something is meant. A lone adjective is none.
  bool stands_for_noun(std::size_t first, std::size_t end, std::size_t& head) const {
    for (std::size_t i = first; i < end; ++i)
      if (tag_at(i) == Tag::number) {
        head = i;
        return true;
      }
    if (first == at_) return false;
    head = end > first ? end - 1 : first - 1;
    return end > first ? tag_at(head) == Tag::adjective
                       : pieces_[head].tokens.size() > 0 && is_alone(head);
  }
  bool is_alone(std::size_t at) const {
    return small_words().standing_alone.count(parse_.tokens[pieces_[at].tokens.begin].text) > 0;
  }

  // The comma or the conjunction between adjectives of one noun.
  bool joins_modifiers(std::size_t i) const {
    if (tag_at(i) != Tag::conjunction && tag_at(i) != Tag::comma) return false;
    const bool both = tag_at(i) == Tag::comma && tag_at(i + 1) == Tag::conjunction;
    const auto next = i + (both ? 2 : 1);
    return i > at_ && tag_at(i - 1) == Tag::adjective && tag_at(next) == Tag::adjective &&
           ends_in_noun(next);
  }
  bool ends_in_noun(std::size_t i) const {
    const std::size_t last = i + longest_phrase;
    while (i < last && (tag_at(i) == Tag::adjective || tag_at(i) == Tag::participle ||
                        tag_at(i) == Tag::adverb))
      ++i;
    return tag_at(i) == Tag::noun;
  }

  // "each of four tables", "each of the desks": says of each what follows, as "each table" does; "each of them" stands
  // for something by itself.
  bool each_of() {
    if (tag_at(at_ + 1) != Tag::preposition || pieces_[at_ + 1].base != "of") return false;
    const auto found = small_words().determiners.find(parse_.tokens[pieces_[at_].tokens.begin].text);
    if (found == small_words().determiners.end() || found->second != Determiner::each) return false;
    const std::size_t first = at_;
    at_ += 2;
    const Extent behind = extent();
    if (behind.has_noun && tag_at(behind.head) == Tag::noun) return true;
    at_ = first;
    return false;
  }

  bool noun_phrase() {
    if (quantity()) return true;
    const std::size_t first = at_;
    const bool is_each = each_of();
    const Extent found = extent();
    if (found.end == at_ || is_bare_measure(found)) return false;
    NounPhrase phrase;
    phrase.tokens = {pieces_[at_].tokens.begin, pieces_[found.end - 1].tokens.end};
    phrase.head = pieces_[found.head].tokens.end - 1;
    phrase.modifiers.begin = static_cast<std::uint32_t>(parse_.modifiers.size());
    take_quantity(phrase);
    for (std::size_t i = at_; i < found.end; ++i)
      if (is_number_of_compound(i, found.head, phrase))
        modifier(Modifier::Kind::noun, {pieces_[i].tokens.begin, pieces_[i + 1].tokens.end}), ++i;
      else
        read(pieces_[i], i == found.head, phrase);
    phrase.modifiers.end = static_cast<std::uint32_t>(parse_.modifiers.size());
    if (phrase.count > 1.0) phrase.is_plural = true;
    if (is_each) phrase.determiner = Determiner::each, phrase.tokens.begin = pieces_[first].tokens.begin;
    add(phrase);
    at_ = found.end;
    return true;
  }

  // "a 14 seat table", which is one.
  bool is_number_of_compound(std::size_t i, std::size_t head, const NounPhrase& phrase) const {
    return tag_at(i) == Tag::number && i + 1 < head && tag_at(i + 1) == Tag::noun &&
           !pieces_[i + 1].is_plural && !pieces_[head].is_plural &&
           phrase.determiner != Determiner::absent && pieces_[i].value > 1.0;
  }

  // "2 m" alone says how far or how high.
  bool is_bare_measure(const Extent& found) const {
    return !found.has_noun && found.end == at_ + 1 && tag_at(at_) == Tag::measure;
  }

  bool names_quantity(std::size_t i) const {
    return tag_at(i) != Tag::stop && tag_at(i + 1) == Tag::preposition && pieces_[i + 1].base == "of" &&
           small_words().quantities.count(parse_.tokens[pieces_[i].tokens.end - 1].text) > 0;
  }

  // "a pair of", "lots of", "a set of": says how many, the thing comes behind.
  bool quantity() {
    std::size_t i = at_;
    while (i < at_ + longest_phrase && !names_quantity(i) &&
           (tag_at(i) == Tag::determiner || tag_at(i) == Tag::number))
      ++i;
    if (!names_quantity(i)) return false;
    const std::string& word = parse_.tokens[pieces_[i].tokens.end - 1].text;
    quantity_ = {pieces_[at_].tokens.begin, 0.0, true};
    const auto counted = small_words().counted_quantities.find(word);
    if (counted != small_words().counted_quantities.end()) {
      quantity_.count = counted->second;
      for (std::size_t k = at_; k < i; ++k)
        if (tag_at(k) == Tag::number) quantity_.count *= pieces_[k].value;
    }
    at_ = i + 2;
    if (extent().end > at_) return true;
    quantity_ = {};
    return true;
  }

  void take_quantity(NounPhrase& phrase) {
    if (!quantity_.is_said) return;
    phrase.tokens.begin = quantity_.from;
    phrase.count = quantity_.count;
    phrase.is_vague = quantity_.count == 0.0;
    quantity_ = {};
  }

  void read(const Piece& piece, bool is_head, NounPhrase& phrase) {
    const std::string& word = parse_.tokens[piece.tokens.begin].text;
    switch (piece.tag) {
      case Tag::pronoun:
        phrase.is_pronoun = is_head;
        if (word == "one") phrase.count = 1.0;
        if (const auto found = small_words().determiners.find(word);
            found != small_words().determiners.end())
          phrase.determiner = found->second;
        phrase.is_denied = small_words().negative_pronouns.count(word) > 0;
        return;
      case Tag::determiner:
        return determiner(word, is_head, phrase);
      case Tag::number:
        phrase.is_pronoun = is_head;
        phrase.count = std::min(piece.value, most_counted);
        phrase.is_vague = false;
        return;
      case Tag::measure:
        phrase.measure = static_cast<std::int32_t>(parse_.measures.size());
        parse_.measures.push_back(piece.measure);
        return;
      case Tag::noun:
        if (is_head) phrase.is_plural = piece.is_plural;
        if (is_head) return hyphened_head(piece);
        return modifier(Modifier::Kind::noun, piece.tokens);
      case Tag::owner:
        return modifier(Modifier::Kind::owner, piece.tokens);
      case Tag::participle:
        return modifier(Modifier::Kind::participle, piece.tokens);
      case Tag::adjective:
        phrase.is_pronoun = phrase.is_pronoun || is_head;
        if (!is_head) modifier(Modifier::Kind::adjective, piece.tokens);
        return;
      default:
        return;
    }
  }

  // "bean-bag": the last word is the head, the rest says what kind.
  void hyphened_head(const Piece& piece) {
    if (piece.tokens.size() > 1)
      modifier(Modifier::Kind::noun, {piece.tokens.begin, piece.tokens.end - 1});
  }

  void determiner(const std::string& word, bool is_head, NounPhrase& phrase) {
    phrase.is_pronoun = is_head;
    if (small_words().vague_numbers.count(word)) phrase.is_vague = true;
    const auto found = small_words().determiners.find(word);
    if (found == small_words().determiners.end()) return;
    phrase.determiner = found->second;
    if (found->second == Determiner::indefinite || found->second == Determiner::another)
      phrase.count = 1.0;
    if (found->second == Determiner::both) phrase.count = 2.0;
    if (found->second == Determiner::no) phrase.is_denied = true;
  }

  void modifier(Modifier::Kind kind, const Run& tokens) {
    Modifier modifier;
    modifier.kind = kind;
    modifier.tokens = tokens;
    parse_.modifiers.push_back(modifier);
  }

  void add(const NounPhrase& phrase) {
    Chunk chunk;
    chunk.phrase = static_cast<std::uint32_t>(parse_.phrases.size());
    parse_.phrases.push_back(phrase);
    chunks_.push_back(chunk);
  }

  void other() {
    Chunk chunk;
    chunk.tag = tag_at(at_);
    chunk.piece = &pieces_[at_];
    if (chunk.tag == Tag::adjective) {
      chunk.complement.begin = static_cast<std::uint32_t>(parse_.modifiers.size());
      modifier(Modifier::Kind::adjective, pieces_[at_].tokens);
      chunk.complement.end = chunk.complement.begin + 1;
    }
    if (chunk.tag == Tag::measure) parse_.measures.push_back(pieces_[at_].measure);
    chunks_.push_back(chunk);
    ++at_;
  }

  struct Quantity {
    std::uint32_t from = 0;
    double count = 0.0;
    bool is_said = false;
  };

  const std::vector<Piece>& pieces_;
  Parse& parse_;
  std::vector<Chunk> chunks_;
  Quantity quantity_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<Chunk> chunk(const std::vector<Piece>& pieces, Parse& parse) {
  return Chunker(pieces, parse).run();
}

}  // namespace roomgen::language
