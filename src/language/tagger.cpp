#include "tagger.h"

#include <cmath>

#include "amount.h"

#include "small_words.h"
#include "tag_model.h"

namespace roomgen::language {

namespace {

// "a bird mobile hanging above it": what no noun phrase is called by, behind a noun and before a preposition, is
// what the thing does, whatever nouns there are of that form ("a wall hanging above it" is one).
std::vector<WordTag> with_gerunds_behind_nouns(std::vector<WordTag> tags, const std::vector<UnitFacts>& facts,
                                               const IsName& is_name) {
  if (!is_name) return tags;
  for (std::size_t i = 1; i + 1 < tags.size(); ++i) {
    const auto& verb = facts[i].may_be.verb;
    const bool is_between = tags[i] == WordTag::noun && tags[i - 1] == WordTag::noun && tags[i + 1] == WordTag::preposition;
    if (is_between && verb && verb->form == VerbForm::gerund && !is_name(facts[i].word) &&
        !is_name(facts[i - 1].word + " " + facts[i].word))
      tags[i] = WordTag::gerund;
  }
  return tags;
}

// "six black and white chairs": colours may be nouns by themselves, but not two of them, joined, before a noun.
std::vector<WordTag> with_joined_colors(std::vector<WordTag> tags, const std::vector<UnitFacts>& facts) {
  const auto is_color = [&](std::size_t i) {
    return (tags[i] == WordTag::noun || tags[i] == WordTag::adjective) &&
           lexicon().may_be(facts[i].word, WordClass::color) && !facts[i].may_be.is_plural;
  };
  for (std::size_t i = 0; i + 3 < tags.size(); ++i)
    if (is_color(i) && tags[i + 1] == WordTag::conjunction && is_color(i + 2) && tags[i + 3] == WordTag::noun)
      tags[i] = tags[i + 2] = WordTag::adjective;
  return tags;
}

// "six stools round a workbench": what is an adjective elsewhere, says where something is behind a thing or a verb and
// before a noun phrase with a determiner or a number of its own.
std::vector<WordTag> with_prepositions_behind_things(std::vector<WordTag> tags, const std::vector<Unit>& units,
                                                     const std::vector<UnitFacts>& facts) {
  const auto stands_before = [&](std::size_t i) {
    return tags[i] == WordTag::noun || tags[i] == WordTag::verb || tags[i] == WordTag::gerund ||
           tags[i] == WordTag::participle || tags[i] == WordTag::adverb;
  };
  const auto begins_phrase = [&](std::size_t i) {
    return tags[i] == WordTag::determiner || tags[i] == WordTag::pronoun || units[i].kind == Unit::Kind::number;
  };
  for (std::size_t i = 1; i + 1 < tags.size(); ++i)
    if (small_words().prepositions_behind_things.contains(facts[i].word) && stands_before(i - 1) && begins_phrase(i + 1))
      tags[i] = WordTag::preposition;
  return tags;
}

// "a kitchen, sink under the window": what things are called by is one where a segment begins with it and says where.
std::vector<WordTag> with_names_before_places(std::vector<WordTag> tags, const std::vector<Unit>& units,
                                              const std::vector<UnitFacts>& facts, const IsName& is_name) {
  if (!is_name) return tags;
  for (std::size_t i = 0; i + 1 < tags.size(); ++i) {
    const bool begins = i == 0 || units[i - 1].kind == Unit::Kind::comma || units[i - 1].kind == Unit::Kind::stop;
    if (begins && tags[i] == WordTag::verb && tags[i + 1] == WordTag::preposition && is_name(facts[i].word))
      tags[i] = WordTag::noun;
  }
  return tags;
}

// What the model says of each, and what it does not know.
std::vector<WordTag> tags_of(const std::vector<Unit>& units, const std::vector<UnitFacts>& facts, const IsName& is_name) {
  auto tags = tag_words(units, facts, tag_model());
  tags = with_gerunds_behind_nouns(std::move(tags), facts, is_name);
  tags = with_joined_colors(std::move(tags), facts);
  tags = with_prepositions_behind_things(std::move(tags), units, facts);
  return with_names_before_places(std::move(tags), units, facts, is_name);
}

/// Makes pieces of units: joins the words of a preposition, parts contractions, and says what the
/// steps behind want to know of a word.
class Tagger {
 public:
  Tagger(const std::vector<Token>& tokens, const IsName& is_name)
      : tokens_(tokens),
        units_(units(tokens)),
        facts_(facts_of(tokens, units_, is_name)),
        tags_(tags_of(units_, facts_, is_name)) {}

  std::vector<Piece> run() {
    while (at_ < units_.size()) {
      const std::size_t length = read();
      at_ += length;
    }
    return std::move(pieces_);
  }

 private:
  const Token& token(std::size_t unit) const { return tokens_[units_[unit].tokens.begin]; }
  const Token& last_token(std::size_t unit) const { return tokens_[units_[unit].tokens.end - 1]; }
  bool is_word(std::size_t unit) const {
    return unit < units_.size() && units_[unit].kind == Unit::Kind::word;
  }
  template <typename List>
  bool is_in(const List& words, std::size_t unit) const {
    return is_word(unit) && units_[unit].tokens.size() == 1 && words.count(token(unit).text) > 0;
  }

  Piece& add(Tag tag, std::size_t length = 1) {
    Piece piece;
    piece.tag = tag;
    piece.tokens = {units_[at_].tokens.begin, units_[at_ + length - 1].tokens.end};
    piece.is_denied = last_token(at_).clitic == "n't";
    pieces_.push_back(std::move(piece));
    return pieces_.back();
  }

  /// How many units it took.
  std::size_t read() {
    add_elided_preposition();
    if (const std::size_t length = amount()) return length;
    switch (units_[at_].kind) {
      case Unit::Kind::stop:
        return add(Tag::stop), 1;
      case Unit::Kind::comma:
        return add(Tag::comma), 1;
      case Unit::Kind::number:
        if (is_reciprocal()) return add(Tag::pronoun, 2), 2;
        add(Tag::number).value = units_[at_].value;
        return 1;
      case Unit::Kind::measure:
        add(Tag::measure).measure = units_[at_].measure;
        return 1;
      default:
        return read_word();
    }
  }

  std::size_t read_word() {
    const auto& words = small_words();
    if (const auto length = run_of(words.subordinators, 2); length > 1)
      return add(Tag::subordinator, length), length;
    if (const auto length = run_of(words.conjunctions, 2); length > 1)
      return conjunction(length), length;
    if (const auto length = run_of(words.adverbs, 2); length > 1)
      return add(Tag::adverb, length), length;
    // "left of" is no verb.
    if (run_of(words.prepositions, 2) > 1) return preposition();
    if (is_in(words.negations, at_)) return negation(), 1;
    if (is_in(words.vague_numbers, at_) && tags_[at_] == WordTag::adjective) return determiner(), 1;
    if (is_reciprocal()) return add(Tag::pronoun, 2), 2;
    if (begins_existence()) {
      add(Tag::there);
      return part_contraction(), 1;
    }
    // "for everyone": what no other list has is a pronoun, whatever its neighbours suggest.
    const bool is_pronoun = is_in(words.pronouns, at_) && !is_in(words.determiners, at_) && !is_in(words.relatives, at_) && !is_in(words.adverbs, at_);
    if (is_pronoun && tags_[at_] != WordTag::pronoun) return add(Tag::pronoun), 1;
    switch (tags_[at_]) {
      case WordTag::determiner:
      case WordTag::quantity:
        return determiner(), 1;
      case WordTag::pronoun:
        // "each long side"
        if (is_in(words.determiners, at_) && continues_phrase(at_ + 1)) return determiner(), 1;
        [[fallthrough]];
      case WordTag::there:
        add(tags_[at_] == WordTag::there ? Tag::there : Tag::pronoun);
        return part_contraction(), 1;
      case WordTag::relative:
        return relative(), 1;
      case WordTag::preposition:
        return preposition();
      case WordTag::conjunction:
        return conjunction(1), 1;
      case WordTag::infinitive:
        return add(Tag::to), 1;
      case WordTag::auxiliary:
        return auxiliary(), 1;
      case WordTag::verb:
        return verb(Tag::verb), 1;
      case WordTag::participle:
        // ", framed art all over the wall": behind a comma, before a noun.
        if (!pieces_.empty() && pieces_.back().tag == Tag::comma && at_ + 1 < units_.size() && tags_[at_ + 1] == WordTag::noun)
          return adjective(), 1;
        [[fallthrough]];
      case WordTag::gerund:
        return verb(is_behind_be() ? Tag::verb : Tag::participle), 1;
      case WordTag::adjective:
        return adjective(), 1;
      case WordTag::owner:
        return add(Tag::owner), 1;
      case WordTag::adverb:
        // "sit atop the desk"
        if (is_in(words.prepositions, at_) && begins_phrase(at_ + 1)) return preposition();
        return add(Tag::adverb), 1;
      case WordTag::noun:
      case WordTag::unit:
        add(Tag::noun).is_plural = facts_[at_].may_be.is_plural;
        return 1;
      default:
        return add(Tag::adverb), 1;
    }
  }

  bool begins_phrase(std::size_t unit) const {
    if (unit >= units_.size()) return false;
    return tags_[unit] == WordTag::determiner || tags_[unit] == WordTag::quantity;
  }

  // "each other", "one another"
  bool is_reciprocal() const {
    if (at_ + 1 >= units_.size() || !is_word(at_ + 1)) return false;
    return (token(at_).is("each") && token(at_ + 1).is("other")) ||
           (token(at_).is("one") && token(at_ + 1).is("another"));
  }

  // "there is", "there's", "there should be"
  bool begins_existence() const {
    if (!is_word(at_) || !token(at_).is("there")) return false;
    return !token(at_).clitic.empty() || is_in(small_words().be, at_ + 1) ||
           is_in(small_words().auxiliaries, at_ + 1);
  }

  bool continues_phrase(std::size_t unit) const {
    if (unit >= units_.size() || !is_word(unit)) return false;
    return tags_[unit] == WordTag::noun || tags_[unit] == WordTag::adjective;
  }

  // The units that are the longest phrase of the list, if at least `least`; else 0.
  std::size_t run_of(const Words& phrases, std::size_t least) const {
    const auto length = longest_run(phrases, tokens_, units_[at_].tokens.begin);
    return length < least ? 0 : units_of(length);
  }
  // How many units so many tokens are; 0 if they end within one.
  std::size_t units_of(std::size_t length) const {
    std::size_t end = at_, covered = 0;
    while (end < units_.size() && covered < length) covered += units_[end++].tokens.size();
    return covered == length ? end - at_ : 0;
  }

  // "8 to 12", "two or three", "about a dozen" are one number, the greatest of it.
  std::size_t amount() {
    const auto said = amount_at(tokens_, units_[at_].tokens.begin);
    const bool is_range = said && said->low > 0.0 && said->low < said->high && !std::isinf(said->high);
    if (!said || said->is_share || (!is_range && !said->is_about)) return 0;
    if (is_word(at_) && units_[at_].kind == Unit::Kind::word && !may_begin_amount()) return 0;
    const std::size_t length = units_of(said->length);
    if (length < 2 || !names_something(at_ + length)) return 0;
    add(Tag::number, length).value = said->high;
    return length;
  }
  // "chairs around six tables" says where, "with around six tables" how many.
  bool may_begin_amount() const {
    if (at_ == 0 || pieces_.empty()) return true;
    switch (pieces_.back().tag) {
      case Tag::stop: case Tag::comma: case Tag::conjunction: case Tag::preposition: case Tag::be: case Tag::determiner:
        return true;
      case Tag::verb: return small_words().verbs_of_having.contains(pieces_.back().base);
      default: return false;
    }
  }
  bool names_something(std::size_t unit) const {
    return unit < units_.size() && is_word(unit) &&
           (tags_[unit] == WordTag::noun || tags_[unit] == WordTag::adjective || tags_[unit] == WordTag::participle);
  }

  // "not" and "never" deny the auxiliary before them too.
  void negation() {
    if (!pieces_.empty() && (pieces_.back().tag == Tag::auxiliary || pieces_.back().tag == Tag::be))
      pieces_.back().is_denied = true;
    add(Tag::negation);
  }

  // Quantity words are determiners; "each" that stands alone came as a pronoun.
  void determiner() {
    add(Tag::determiner);
    part_contraction();
  }

  void relative() {
    const bool is_subordinator = run_of(small_words().subordinators, 1) == 1;
    add(is_subordinator ? Tag::subordinator : Tag::relative);
    part_contraction();
  }

  void conjunction(std::size_t length) {
    Piece& piece = add(Tag::conjunction, length);
    for (auto i = piece.tokens.begin; i < piece.tokens.end; ++i)
      piece.base += (piece.base.empty() ? "" : " ") + tokens_[i].text;
  }

  std::size_t preposition() {
    const std::size_t known = std::max<std::size_t>(1, run_of(small_words().prepositions, 2));
    Piece& piece = add(Tag::preposition, known);
    for (auto i = piece.tokens.begin; i < piece.tokens.end; ++i)
      piece.base += (piece.base.empty() ? "" : " ") + tokens_[i].text;
    return known;
  }

  // "a lamp either side of the bed": "on", which takes no words, where sides stand behind what is there.
  void add_elided_preposition() {
    if (pieces_.empty() || run_of(small_words().sides_without_preposition, 2) == 0) return;
    const Tag before = pieces_.back().tag;
    if (before != Tag::noun && before != Tag::number && before != Tag::pronoun) return;
    Piece piece;
    piece.tag = Tag::preposition;
    piece.tokens = {units_[at_].tokens.begin, units_[at_].tokens.begin};
    piece.base = "on";
    pieces_.push_back(std::move(piece));
  }

  void auxiliary() {
    const bool is_be = is_in(small_words().be, at_);
    Piece& piece = add(is_be ? Tag::be : Tag::auxiliary);
    piece.base = is_be ? "be" : token(at_).text;
  }

  void verb(Tag tag) {
    const auto& found = facts_[at_].may_be.verb;
    Piece& piece = add(tag);
    piece.base = found ? found->base : last_token(at_).text;
    if (found) piece.form = found->form;
    // "set" and "put" are their own participles.
    if (tags_[at_] == WordTag::participle) piece.form = VerbForm::past;
    if (tags_[at_] == WordTag::gerund) piece.form = VerbForm::gerund;
    piece.is_clause = true;
    if (tag == Tag::verb) part_contraction();
  }

  bool is_behind_be() const {
    for (auto i = pieces_.size(); i-- > 0;) {
      if (pieces_[i].tag == Tag::be) return true;
      if (pieces_[i].tag != Tag::adverb && pieces_[i].tag != Tag::negation) return false;
    }
    return false;
  }

  void adjective() {
    const auto& found = facts_[at_].may_be.verb;
    const bool is_participle = units_[at_].tokens.size() == 1 && facts_[at_].may_be.is_participle();
    Piece& piece = add(is_participle ? Tag::participle : Tag::adjective);
    if (is_participle) piece.base = found->base, piece.form = found->form;
  }

  // "there's", "it's", "they'd": the clitic is a piece of its own in the same token.
  void part_contraction() {
    const std::string& clitic = last_token(at_).clitic;
    const auto& contractions = small_words().contractions;
    const bool is_be = clitic == "'s" || clitic == "'re" || clitic == "'m";
    if (!is_be && !contractions.count(clitic)) return;
    Piece& piece = add(is_be ? Tag::be : Tag::auxiliary);
    piece.base = is_be ? "be" : contractions.find(clitic)->second;
    piece.is_denied = false;
  }

  const std::vector<Token>& tokens_;
  const std::vector<Unit> units_;
  const std::vector<UnitFacts> facts_;
  const std::vector<WordTag> tags_;
  std::vector<Piece> pieces_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<Piece> tag(const std::vector<Token>& tokens, const IsName& is_name) {
  return Tagger(tokens, is_name).run();
}

}  // namespace roomgen::language
