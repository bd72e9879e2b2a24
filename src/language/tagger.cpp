#include "tagger.h"

#include <algorithm>
#include <map>
#include <utility>

#include "candidates.h"
#include "roomgen/language/lexicon.h"
#include "roomgen/language/number.h"
#include "small_words.h"

namespace roomgen::language {

namespace {

class Tagger {
 public:
  explicit Tagger(const std::vector<Token>& tokens) : tokens_(tokens), known_(tokens.size()) {}

  std::vector<Piece> run() {
    while (at_ < tokens_.size()) {
      if (mark() || measured() || hyphened() || small()) continue;
      content();
    }
    return std::move(pieces_);
  }

 private:
  const Candidates& about(std::size_t at) {
    static const Candidates nothing;
    if (at >= tokens_.size()) return nothing;
    if (!known_[at]) {
      // Words come again: each is looked up once.
      const auto key = std::pair(tokens_[at].kind, std::string_view(tokens_[at].text));
      const auto found = words_.find(key);
      known_[at] = found != words_.end()
                       ? &found->second
                       : &words_.emplace(key, candidates(tokens_[at])).first->second;
    }
    return *known_[at];
  }
  bool is(std::size_t at, std::string_view word) const {
    return at < tokens_.size() && tokens_[at].is(word);
  }
  template <typename List>
  bool is_in(const List& words, std::size_t at) const {
    return at < tokens_.size() && tokens_[at].kind == Token::Kind::word &&
           words.count(tokens_[at].text);
  }

  Piece& add(Tag tag, std::size_t length) {
    Piece piece;
    piece.tag = tag;
    piece.tokens = {static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(at_ + length)};
    at_ += length;
    pieces_.push_back(std::move(piece));
    note(pieces_.back());
    return pieces_.back();
  }

  // Clauses begin anew behind stops and subordinators; a list of subjects is in the plural.
  void note(const Piece& piece) {
    note_subject(piece.tag);
    if (piece.tag == Tag::stop || piece.tag == Tag::subordinator) {
      has_verb_ = is_listing_ = is_in_relative_ = false;
      subject_ = Subject::unknown;
    }
    if (piece.tag == Tag::relative) {
      has_verb_ = false;
      is_in_relative_ = true;
    }
    if (piece.tag == Tag::conjunction || piece.tag == Tag::comma) {
      is_listing_ = !has_verb_;
      if (has_verb_ && !is_in_relative_) subject_ = Subject::unknown;
      if (!has_verb_) subject_ = Subject::plural;
      // "..., and the armchairs face it": another clause may come.
      has_verb_ = false;
    }
    if (piece.tag == Tag::be || piece.tag == Tag::auxiliary || piece.tag == Tag::verb)
      has_verb_ = true;
  }

  // The first noun phrase of a clause is the subject, whatever comes between it and its verb.
  void note_subject(Tag tag) {
    if (subject_ != Subject::unknown || pieces_.size() < 2) return;
    const Piece& last = pieces_[pieces_.size() - 2];
    if (last.tag == Tag::noun && tag != Tag::noun)
      subject_ = last.is_plural ? Subject::plural : Subject::singular;
  }

  // How far back pieces are looked at, so that no text takes long.
  std::size_t oldest() const { return pieces_.size() - std::min(pieces_.size(), longest_phrase); }

  // What was said before, adverbs and negations aside.
  const Piece* before() const {
    for (auto i = pieces_.size(); i-- > oldest();)
      if (pieces_[i].tag != Tag::adverb && pieces_[i].tag != Tag::negation) return &pieces_[i];
    return nullptr;
  }
  bool follows(Tag tag) const { return before() && before()->tag == tag; }
  bool begins_clause() const {
    const Piece* piece = before();
    return !piece || piece->tag == Tag::stop || piece->tag == Tag::comma ||
           piece->tag == Tag::conjunction || piece->tag == Tag::subordinator;
  }
  // Within a noun phrase that has no noun yet.
  bool awaits_noun() const {
    if (pieces_.empty()) return false;
    switch (pieces_.back().tag) {
      case Tag::determiner:
      case Tag::number:
      case Tag::measure:
      case Tag::owner:
        return true;
      case Tag::adjective:
      case Tag::participle:
        return !pieces_.back().tokens.empty() && is_in_phrase_;
      case Tag::adverb:
        return is_in_phrase_ && !follows(Tag::noun);
      default:
        return false;
    }
  }

  bool mark() {
    switch (tokens_[at_].kind) {
      case Token::Kind::stop:
        add(Tag::stop, 1);
        break;
      case Token::Kind::comma:
      case Token::Kind::open:
      case Token::Kind::close:
        add(Tag::comma, 1);
        break;
      case Token::Kind::quote:
      case Token::Kind::symbol:
        ++at_;
        return true;
      default:
        return false;
    }
    is_in_phrase_ = false;
    return true;
  }

  bool measured() {
    // "the other half", "a metre"
    // "the smaller one"
    if ((is(at_, "one") || is(at_, "ones")) && awaits_noun() && follows(Tag::adjective)) {
      const bool is_plural = is(at_, "ones");
      add(Tag::noun, 1).is_plural = is_plural;
      return true;
    }
    const bool is_noun =
        follows(Tag::determiner) && small_words().fractions.count(tokens_[at_].text);
    if (is_noun || is_in(small_words().ordinals, at_)) return false;
    if (const auto measure = measure_at(tokens_, at_);
        measure && (measure->has_unit || measure->count > 1)) {
      add(Tag::measure, measure->length).measure = *measure;
      is_in_phrase_ = true;
      return true;
    }
    const auto number = number_at(tokens_, at_);
    if (!number) return false;
    const std::size_t next = at_ + number->length;
    // "three-seater", "4-legged": part of a word.
    if (next < tokens_.size() && tokens_[next].joint == Token::Joint::hyphen) return false;
    add(Tag::number, number->length).value = number->value;
    is_in_phrase_ = true;
    return true;
  }

  bool is_nominal(std::size_t at) {
    const auto& word = about(at);
    return word.is_content && !is_in(small_words().verbs, at) &&
           (word.is_noun || word.is_adjective || word.is_participle()) && !is_likely_verb(at);
  }
  // "stands": met more often as a verb.
  bool is_likely_verb(std::size_t at) {
    const auto& word = about(at);
    return word.verb && word.verb->form == VerbForm::third_person &&
           word.verb_uses > 2 * word.noun_uses;
  }
  // What a noun phrase can begin with.
  bool begins_phrase(std::size_t at) {
    if (at >= tokens_.size()) return false;
    const Token& token = tokens_[at];
    if (token.kind == Token::Kind::number || token.kind == Token::Kind::ordinal) return true;
    return small_words().determiners.count(token.text) || small_words().numbers.count(token.text) ||
           small_words().pronouns.count(token.text) ||
           small_words().vague_numbers.count(token.text) || is_nominal(at);
  }

  // "L-shaped", "walk-in", "bean-bag"
  bool hyphened() {
    std::size_t end = at_ + 1;
    while (end < tokens_.size() && tokens_[end].joint == Token::Joint::hyphen) ++end;
    if (end == at_ + 1 || small_words().conjunctions.count(tokens_[end - 1].text)) return false;
    const auto& last = about(end - 1);
    const bool is_noun = last.is_noun && !last.is_participle() && !is_nominal(end);
    Piece& piece = add(is_noun ? Tag::noun : Tag::adjective, end - at_);
    piece.is_plural = is_noun && last.is_plural;
    is_in_phrase_ = true;
    return true;
  }

  bool small() {
    return there() || negation() || subordinator() || relative() || conjunction() || infinitive() ||
           preposition() || determiner() || pronoun() || auxiliary() || adverb();
  }

  bool there() {
    if (!is(at_, "there")) return false;
    const bool contracted = !tokens_[at_].clitic.empty();
    if (!contracted && !is_in(small_words().be, at_ + 1) &&
        !is_in(small_words().auxiliaries, at_ + 1))
      return false;
    add(Tag::there, 1);
    if (contracted) add_be_of_clitic();
    return true;
  }

  // "there's": the clitic is a piece of its own in the same token.
  void add_be_of_clitic() {
    --at_;
    add(Tag::be, 1).base = "be";
    is_in_phrase_ = false;
  }

  bool negation() {
    if (!is_in(small_words().negations, at_)) return false;
    if (!pieces_.empty() && (pieces_.back().tag == Tag::auxiliary || pieces_.back().tag == Tag::be))
      pieces_.back().is_denied = true;
    add(Tag::negation, 1);
    return true;
  }

  bool subordinator() {
    const auto length = longest_run(small_words().subordinators, tokens_, at_);
    if (length == 0 || (is(at_, "so") && length == 1 && !begins_clause())) return false;
    add(Tag::subordinator, length);
    is_in_phrase_ = false;
    return true;
  }

  // "that" and "which" behind a noun, before a verb or a subject.
  bool relative() {
    if (!is_in(small_words().relatives, at_) || is(at_, "whose")) return false;
    const bool behind = follows(Tag::noun) || follows(Tag::pronoun) || follows(Tag::comma) ||
                        follows(Tag::preposition);
    if (is(at_, "that") && (!behind || follows(Tag::preposition) || !begins_verb(at_ + 1)))
      return false;
    add(Tag::relative, 1);
    if (!tokens_[at_ - 1].clitic.empty()) add_be_of_clitic();
    is_in_phrase_ = false;
    return true;
  }
  bool begins_verb(std::size_t at) {
    return is_in(small_words().be, at) || is_in(small_words().auxiliaries, at) ||
           is_in(small_words().verbs, at) || (about(at).is_finite() && about(at).verb_uses > 0) ||
           is_in(small_words().pronouns, at);
  }

  bool conjunction() {
    const auto length = longest_run(small_words().conjunctions, tokens_, at_);
    if (length == 0) return false;
    Piece& piece = add(Tag::conjunction, length);
    piece.base = tokens_[piece.tokens.begin].text;
    is_in_phrase_ = false;
    return true;
  }

  bool infinitive() {
    if (!is(at_, "to") || !about(at_ + 1).verb || about(at_ + 1).verb->form != VerbForm::base)
      return false;
    if (about(at_ + 1).noun_uses > 2 * about(at_ + 1).verb_uses && !begins_phrase(at_ + 2))
      return false;
    add(Tag::to, 1);
    return true;
  }

  bool preposition() {
    const auto length = longest_run(small_words().prepositions, tokens_, at_);
    if (length == 0) return false;
    // "the opposite wall", "storage underneath"
    if (length == 1 && awaits_noun() && is_nominal(at_ + 1)) {
      add(Tag::adjective, 1);
      return true;
    }
    const bool has_object =
        begins_phrase(at_ + length) ||
        (at_ + length < tokens_.size() && tokens_[at_ + length].kind == Token::Kind::quote) ||
        is_in(small_words().relatives, at_ + length) ||
        is_in(small_words().standing_alone, at_ + length) ||
        is_in(small_words().prepositions, at_ + length) || about(at_ + length).verb;
    Piece& piece = add(has_object ? Tag::preposition : Tag::adverb, length);
    for (auto i = piece.tokens.begin; i < piece.tokens.end; ++i)
      piece.base += (piece.base.empty() ? "" : " ") + tokens_[i].text;
    is_in_phrase_ = false;
    return true;
  }

  bool determiner() {
    if (tokens_[at_].kind != Token::Kind::word) return false;
    const bool is_vague = small_words().vague_numbers.count(tokens_[at_].text) > 0;
    if (!small_words().determiners.count(tokens_[at_].text) && !is_vague && !is(at_, "other"))
      return false;
    // "each with a lamp", "the other faces the door"
    const bool stands_alone =
        small_words().standing_alone.count(tokens_[at_].text) && !begins_phrase(at_ + 1) &&
        !is_in(small_words().prepositions, at_ + 1 + (is(at_ + 1, "of") ? 9 : 0));
    const bool is_alone = small_words().standing_alone.count(tokens_[at_].text) &&
                          (stands_alone || !continues_phrase(at_ + 1));
    // "that's", "it's"
    const bool contracted = tokens_[at_].clitic == "'s";
    add(is_alone || contracted ? Tag::pronoun : Tag::determiner, 1);
    if (contracted) add_be_of_clitic();
    is_in_phrase_ = !is_alone && !contracted;
    return true;
  }
  bool continues_phrase(std::size_t at) {
    if (at >= tokens_.size()) return false;
    if (tokens_[at].kind == Token::Kind::number || small_words().numbers.count(tokens_[at].text) ||
        small_words().determiners.count(tokens_[at].text) || is(at, "of") || is(at, "other"))
      return true;
    // "each surrounded by": a participle that nothing follows is none of a noun.
    const auto& word = about(at);
    if (word.is_participle() && !is_nominal(at + 1))
      return word.is_noun && word.verb->form == VerbForm::gerund;
    return is_nominal(at);
  }

  bool pronoun() {
    if (!is_in(small_words().pronouns, at_)) return false;
    add(Tag::pronoun, 1);
    const std::string& clitic = tokens_[at_ - 1].clitic;
    if (clitic == "'s" || clitic == "'re" || clitic == "'m") {
      add_be_of_clitic();
    } else if (small_words().contractions.count(clitic)) {
      --at_;
      add(Tag::auxiliary, 1);
    }
    is_in_phrase_ = false;
    return true;
  }

  bool auxiliary() {
    const bool is_be = is_in(small_words().be, at_);
    if (!is_be && !is_in(small_words().auxiliaries, at_)) return false;
    Piece& piece = add(is_be ? Tag::be : Tag::auxiliary, 1);
    piece.base = is_be ? "be" : tokens_[at_ - 1].text;
    piece.is_denied = tokens_[at_ - 1].clitic == "n't";
    is_in_phrase_ = false;
    return true;
  }

  bool adverb() {
    auto length = longest_run(small_words().adverbs, tokens_, at_);
    const auto& word = about(at_);
    if (length == 0 && word.is_adverb && !word.is_noun && !word.verb &&
        (!word.is_adjective || tokens_[at_].text.ends_with("ly")))
      length = 1;
    if (length == 0 || (length == 1 && is(at_, "right") && awaits_noun())) return false;
    add(Tag::adverb, length);
    return true;
  }

  void content() {
    const auto& word = about(at_);
    const bool owns =
        !tokens_[at_].clitic.empty() && (tokens_[at_].clitic == "'s" || tokens_[at_].clitic == "'");
    if (owns && is_nominal(at_ + 1)) {
      add(Tag::owner, 1);
      is_in_phrase_ = true;
    } else if (awaits_noun()) {
      in_phrase(word);
    } else if (follows(Tag::noun) && is_in_phrase_) {
      behind_noun(word);
    } else {
      outside(word);
    }
  }

  void add_noun(const Candidates& word) {
    const bool is_plural = word.is_plural;
    add(Tag::noun, 1).is_plural = is_plural;
    is_in_phrase_ = true;
  }
  void add_modifier(Tag tag) {
    const std::size_t at = at_;
    Piece& piece = add(tag, 1);
    if (about(at).verb) piece.base = about(at).verb->base, piece.form = about(at).verb->form;
    is_in_phrase_ = true;
  }
  void add_verb(const Candidates& word, Tag tag = Tag::verb) {
    const Verb found = *word.verb;
    Piece& piece = add(tag, 1);
    piece.base = found.base;
    piece.form = found.form;
    piece.is_clause = true;
    piece.is_denied = tokens_[at_ - 1].clitic == "n't";
    is_in_phrase_ = false;
  }

  void in_phrase(const Candidates& word) {
    const bool goes_on = is_nominal(at_ + 1) || (about(at_ + 1).is_content && !about(at_ + 1).verb);
    if (goes_on && word.is_adjective) return add_modifier(Tag::adjective);
    if (goes_on && word.is_participle() && !is_compound(at_)) return add_modifier(Tag::participle);
    if (is_listed_modifier(word)) return add_modifier(Tag::adjective);
    if (word.is_noun) return add_noun(word);
    if (word.is_adjective) return add_modifier(Tag::adjective);
    if (word.is_participle()) return add_modifier(Tag::participle);
    if (word.verb && pieces_.back().tag == Tag::number) return add_verb(word);
    add_noun(word);
  }

  // "a tall, narrow shelf", "a black and white rug": adjectives that share their noun.
  bool is_listed_modifier(const Candidates& word) {
    if (!word.is_adjective || follows(Tag::owner)) return false;
    std::size_t next = at_ + 1;
    if (next >= tokens_.size()) return false;
    const bool joined = tokens_[next].kind == Token::Kind::comma || is(next, "and") ||
                        is(next, "but") || is(next, "or");
    if (!joined || !about(next + 1).is_adjective || !is_nominal(next + 2)) return false;
    return word.is_rather_adjective() || is(next, "and");
  }

  bool is_compound(std::size_t at) {
    return at + 1 < tokens_.size() &&
           lexicon().has(tokens_[at].text + " " + singular(tokens_[at + 1].text),
                         PartOfSpeech::noun);
  }

  // Whether the noun phrase that was read is one thing, by its last noun and its number.
  bool is_singular() const {
    if (is_listing_) return false;
    for (auto i = pieces_.size(); i-- > oldest();) {
      if (pieces_[i].tag == Tag::noun && i + 1 == pieces_.size() && pieces_[i].is_plural)
        return false;
      if (pieces_[i].tag == Tag::number) return pieces_[i].value <= 1.0;
      if (pieces_[i].tag != Tag::noun && pieces_[i].tag != Tag::adjective &&
          pieces_[i].tag != Tag::participle)
        break;
    }
    return true;
  }
  bool awaits_plural() const {
    for (auto i = pieces_.size(); i-- > oldest();) {
      if (pieces_[i].tag == Tag::noun && pieces_[i].is_plural) return false;
      if (pieces_[i].tag == Tag::number) return pieces_[i].value > 1.0;
      if (pieces_[i].tag != Tag::noun && pieces_[i].tag != Tag::adjective &&
          pieces_[i].tag != Tag::participle)
        return false;
    }
    return false;
  }

  // "Next to the bed place a lamp": the base form agrees with nothing, and a noun has no object.
  bool is_command_behind(const Candidates& word) {
    return word.verb && word.verb->form == VerbForm::base && word.verb_uses > 0 && !has_verb_ &&
           at_ + 1 < tokens_.size() &&
           (small_words().determiners.count(tokens_[at_ + 1].text) ||
            tokens_[at_ + 1].kind == Token::Kind::number ||
            small_words().numbers.count(tokens_[at_ + 1].text));
  }

  void behind_noun(const Candidates& word) {
    if (is_command_behind(word)) return add_verb(word);
    if (is_finite_here(word)) return add_verb(word);
    if (word.is_participle() && !is_in_compound(word)) return add_verb(word, Tag::participle);
    if (word.is_adjective && (word.is_rather_adjective() || is(at_ + 1, "of")) &&
        !is_nominal(at_ + 1))
      return add_modifier(Tag::adjective);
    if (word.is_adjective && !word.is_noun) return add_modifier(Tag::adjective);
    add_noun(word);
  }

  // "washing machine", "coffee drinking table": what stands between nouns, rather than a clause.
  bool is_in_compound(const Candidates& word) {
    if (!is_nominal(at_ + 1))
      return word.is_noun && word.verb->form == VerbForm::gerund && !begins_phrase(at_ + 1) &&
             is_known_pair();
    if (word.verb->form == VerbForm::past) return false;
    return is_compound(at_) || !about(at_ + 1).is_plural;
  }
  bool is_known_pair() {
    return at_ > 0 &&
           lexicon().has(tokens_[at_ - 1].text + " " + tokens_[at_].text, PartOfSpeech::noun);
  }

  // A finite verb agrees with its subject, and is no noun that the phrase still waits for.
  bool is_finite_here(const Candidates& word) {
    if (is_in(small_words().verbs, at_) && word.verb && !awaits_plural() && !has_verb_)
      return agrees(word);
    if (!word.is_finite() || has_verb_ || awaits_plural() || !agrees(word)) return false;
    if (!word.is_noun) return true;
    if (at_ + 1 >= tokens_.size() || tokens_[at_ + 1].kind != Token::Kind::word ||
        is_in(small_words().conjunctions, at_ + 1))
      return tokens_.size() > at_ + 1 && tokens_[at_ + 1].kind == Token::Kind::number;
    if (is_in(small_words().be, at_ + 1) || is_in(small_words().auxiliaries, at_ + 1)) return false;
    const bool has_object = (small_words().determiners.count(tokens_[at_ + 1].text) ||
                             small_words().numbers.count(tokens_[at_ + 1].text) ||
                             tokens_[at_ + 1].kind == Token::Kind::number ||
                             small_words().pronouns.count(tokens_[at_ + 1].text));
    if (is_known_pair() && !has_object) return false;
    return has_object || word.verb_uses > word.noun_uses;
  }
  bool agrees(const Candidates& word) const {
    if (word.verb->form == VerbForm::base) return !is_singular() || subject_ == Subject::plural;
    return is_singular() || word.verb->form == VerbForm::past || subject_ == Subject::singular;
  }

  void outside(const Candidates& word) {
    if (follows(Tag::auxiliary) || follows(Tag::to) || follows(Tag::there)) {
      if (word.verb) return add_verb(word);
    } else if (follows(Tag::be)) {
      if (word.is_participle() && !is_nominal(at_ + 1)) return add_verb(word);
      if (word.is_rather_adjective() && !is_nominal(at_ + 1)) return add_modifier(Tag::adjective);
    } else if (follows(Tag::pronoun) || follows(Tag::relative)) {
      if (word.is_participle() && !is_in(small_words().verbs, at_) && follows(Tag::pronoun))
        return add_verb(word, Tag::participle);
      if (word.verb && (!word.is_adjective || word.verb_uses > 0)) return add_verb(word);
    } else if (begins_clause() && is_imperative(word)) {
      return add_verb(word);
    } else if (word.is_finite() && !word.is_noun && !word.is_adjective) {
      return add_verb(word);
    } else if (word.is_finite() && !has_verb_ && is_inverted(word)) {
      return add_verb(word);
    } else if (word.is_participle() && !word.is_adjective && !word.is_noun &&
               !is_nominal(at_ + 1)) {
      return add_verb(word, Tag::participle);
    }
    in_phrase_start(word);
  }

  void in_phrase_start(const Candidates& word) {
    is_in_phrase_ = false;
    in_phrase(word);
  }

  // "On the left stands a cabinet" comes here when the noun before was no noun phrase's.
  bool is_inverted(const Candidates& word) {
    return !word.is_rather_adjective() && word.verb_uses > word.noun_uses && begins_phrase(at_ + 1);
  }

  // "Place two chairs", "Hang pictures"; but "Mirror wall", "Table with a lamp".
  bool is_imperative(const Candidates& word) {
    if (!word.verb || word.verb->form != VerbForm::base || at_ + 1 >= tokens_.size()) return false;
    const bool is_first =
        !before() || before()->tag == Tag::stop || has_imperative_ || follows(Tag::subordinator);
    const Token& next = tokens_[at_ + 1];
    const bool has_object =
        next.kind == Token::Kind::number || small_words().determiners.count(next.text) ||
        small_words().numbers.count(next.text) || small_words().pronouns.count(next.text) ||
        small_words().vague_numbers.count(next.text);
    const bool is_one =
        has_object || ((!word.is_noun || word.verb_uses > word.noun_uses) &&
                       begins_phrase(at_ + 1) && next.joint != Token::Joint::hyphen);
    const bool comes_late =
        !is_first && before() && before()->tag == Tag::comma && has_object && word.verb_uses > 0;
    if (!is_one || !(is_first || comes_late)) return false;
    if (word.is_adjective && !has_object && word.verb_uses < 20) return false;
    has_imperative_ = true;
    return true;
  }

  enum class Subject { unknown, singular, plural };

  const std::vector<Token>& tokens_;
  std::vector<const Candidates*> known_;  ///< of words_, by token
  std::map<std::pair<Token::Kind, std::string_view>, Candidates> words_;
  std::vector<Piece> pieces_;
  std::size_t at_ = 0;
  bool is_in_phrase_ = false, has_verb_ = false, is_listing_ = false, has_imperative_ = false;
  bool is_in_relative_ = false;
  Subject subject_ = Subject::unknown;  ///< of the clause that is open
};

}  // namespace

std::vector<Piece> tag(const std::vector<Token>& tokens) {
  return Tagger(tokens).run();
}

}  // namespace roomgen::language
