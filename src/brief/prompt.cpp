#include "prompt.h"

#include <algorithm>

#include "absence.h"
#include "discourse.h"
#include "finishes.h"
#include "measures.h"
#include "opening_phrase.h"
#include "room_type.h"
#include "settle.h"
#include "shape_words.h"
#include "tokens.h"

namespace roomgen::design {

namespace {

constexpr std::size_t longest_placement = 6;
constexpr int most_for_each = 40;

/// Reads a prompt from left to right.
class PromptReader {
 public:
  PromptReader(std::vector<Token> tokens, const Lexicon& lexicon, Brief& brief)
      : tokens_(std::move(tokens)),
        words_(lexicon.words),
        table_(lexicon.table),
        brief_(brief),
        talk_(lexicon, brief) {}

  void run() {
    while (at_ < tokens_.size()) {
      const Token::Kind kind = tokens_[at_].kind;
      if (kind == Token::Kind::stop) {
        end_sentence();
      } else if (kind == Token::Kind::room) {
        talk_.speak_of(std::nullopt);
      } else if (read_bare() || read_some_of() || read_negation() || read_openings() ||
                 read_placement() || read_thing()) {
        continue;
      }
      if (words_.verbs.count(tokens_[at_].text)) talk_.close_list();
      if (is_word(at_, "where")) where_ = last_target_;
      ++at_;
    }
  }

 private:
  bool is_word(std::size_t i, std::string_view word) const {
    return i < tokens_.size() && tokens_[i].is_word(word);
  }

  void end_sentence() {
    talk_.end_sentence();
    where_.reset();
    last_target_.reset();
    sentence_start_ = at_ + 1;
  }

  // --- Things ---------------------------------------------------------------------------------

  // Where a noun may be a thing even if nobody knows it.
  bool lists(std::size_t i) const {
    static const WordSet words = {
        "with",     "and",       "has",       "have",     "contains", "containing", "include",
        "includes", "including", "featuring", "features", "plus",     "add",        "is",
        "are",      "stands",    "sits",      "hangs",    "want",     "need",       "also"};
    if (i == sentence_start_) return true;
    const Token& before = tokens_[i - 1];
    return before.kind == Token::Kind::comma || words.count(before.text) > 0;
  }

  bool read_thing() {
    const auto phrase = read_noun_phrase(tokens_, at_, words_, table_, lists(at_));
    if (!phrase) return false;
    const bool part = describes_owner(*phrase) || is_on_small_owner(*phrase);
    const auto owner = talk_.subject();
    const bool with = phrase->begin == owner_end_ + 1 && is_word(owner_end_, "with");
    const bool continues = phrase->begin > 0 && (is_word(phrase->begin - 1, "and") ||
                                                 tokens_[phrase->begin - 1].kind == Token::Kind::comma);
    const std::size_t before = talk_.count();
    after_part_ = part;
    if (!part) talk_.speak_of(refer(*phrase));
    at_ = phrase->end;
    owner_end_ = at_;
    if (part || !talk_.subject()) return true;
    if (clause_begins()) talk_.close_list();
    if (with && owner && owner != talk_.subject() && talk_.may_carry(*owner)) {
      talk_.open_list({{RelationKind::on, *owner, "", false}});
      talk_.join_with(*owner);
    }
    if (talk_.count() > before && (with || continues)) talk_.extend_list(*talk_.subject());
    talk_.apply_leading(*talk_.subject());
    return true;
  }

  // "… and a lamp stands": what was said of a list is not said of it.
  bool clause_begins() const {
    std::size_t i = owner_end_;
    while (i < tokens_.size() && is_adverb(tokens_[i])) ++i;
    return i < tokens_.size() && words_.verbs.count(tokens_[i].text) > 0;
  }

  bool is_adverb(const Token& token) const {
    return token.kind == Token::Kind::word &&
           ((token.text.size() > 4 && token.text.ends_with("ly")) ||
            words_.adverbs.count(token.text) > 0);
  }

  // "a desk with drawers": drawers are no thing of their own.
  bool describes_owner(const NounPhrase& phrase) const {
    if (is_built_in(phrase)) return true;
    if (!talk_.subject() || phrase.begin == 0 || phrase.begin - 1 != owner_end_) return false;
    static const WordSet links = {"with", "featuring", "has"};
    const Token& before = tokens_[phrase.begin - 1];
    // "with drawers and a shelf", but "a desk and a shelf".
    const bool goes_on =
        after_part_ && (before.kind == Token::Kind::comma || before.is_word("and"));
    return (goes_on || links.count(before.text)) &&
           words_.parts.count(tokens_[phrase.end - 1].text) > 0;
  }

  // "with an integrated sink"
  bool is_built_in(const NounPhrase& phrase) const {
    return std::any_of(phrase.modifiers.begin(), phrase.modifiers.end(),
                       [&](const std::string& word) { return words_.built_in.count(word) > 0; });
  }

  // "a photo frame with a black-and-white print": no other picture.
  bool is_on_small_owner(const NounPhrase& phrase) const {
    return talk_.subject() && phrase.begin == owner_end_ + 1 && is_word(owner_end_, "with") &&
           phrase.kind.length > 0 && phrase.kind.category->mount == Mount::wall &&
           talk_.mention(*talk_.subject()).mount == Mount::surface;
  }

  std::optional<std::size_t> refer(const NounPhrase& phrase) {
    const std::size_t before = talk_.count();
    const auto mention = talk_.refer(phrase);
    if (talk_.count() == before) return mention;
    if (for_each(phrase, before)) talk_.multiply_last(talk_.mention(before - 1).quantity);
    talk_.list(*mention, continues_list(phrase.begin));
    return mention;
  }

  // "a desk, a chair and a lamp": after a comma or an "and" that follows a thing.
  bool continues_list(std::size_t begin) const {
    return begin > 0 && begin <= owner_end_ + 2 && begin != leading_end_ + 1 &&
           (is_word(begin - 1, "and") || tokens_[begin - 1].kind == Token::Kind::comma);
  }

  // "two nightstands, each with a lamp"
  bool for_each(const NounPhrase& phrase, std::size_t before) const {
    return before > 0 && phrase.begin >= 2 && is_word(phrase.begin - 2, "each") &&
           talk_.mention(before - 1).quantity <= most_for_each;
  }

  // "one of them", "the other": some of what was spoken of; what is said of them is not followed.
  bool read_some_of() {
    const auto refers_back = [&](std::size_t i) {
      return i < tokens_.size() && (words_.pronouns.count(tokens_[i].text) > 0 ||
                                    words_.definite.count(tokens_[i].text) > 0);
    };
    // "one holds a lamp, the other a plant"
    const bool holder = is_word(at_, "one") && holds(at_ + 1);
    const bool other_holder = is_word(at_, "the") && is_word(at_ + 1, "other") && holds(at_ + 2);
    if ((holder || other_holder) && talk_.speak_of_one_of_them(other_holder)) {
      at_ += holder ? 1 : 2;
      return true;
    }
    const bool one = is_word(at_, "one") && is_word(at_ + 1, "of") && refers_back(at_ + 2);
    const bool other = is_word(at_, "the") &&
                       (is_word(at_ + 1, "other") || is_word(at_ + 1, "others")) &&
                       mention_at(table_, tokens_, at_ + 2).length == 0 && !is_word(at_ + 2, "wall") &&
                       !is_word(at_ + 2, "side");
    if (!one && !other) return false;
    talk_.speak_of(std::nullopt);
    at_ += one ? 3 : 2;
    return true;
  }

  bool holds(std::size_t i) const {
    const auto match = longest(words_.placements, tokens_, i, longest_placement);
    return match && match.value->inverse;
  }

  // --- Placements -----------------------------------------------------------------------------

  bool read_placement() {
    auto match = longest(words_.placements, tokens_, at_, longest_placement);
    // "on each side table" is on a table.
    if (match && match.length > 1 && mention_at(table_, tokens_, at_ + match.length - 1).length > 1)
      match = longest(words_.placements, tokens_, at_, match.length - 1);
    if (!match && is_adverb(tokens_[at_])) {
      // "directly under the window"
      match = longest(words_.placements, tokens_, at_ + 1, longest_placement);
      if (match) ++match.length;
    }
    if (!match) return false;
    const Placement& placement = *match.value;
    const std::size_t after = at_ + match.length;
    if (placement.inverse) return read_inverse(placement, after);
    if (placement.pronoun) {
      hear_plural();
      const bool read = read_implied_target(placement, after);
      talk_.speak_of_one();
      return read;
    }
    if (placement.mutual) {
      talk_.relate_listed(placement);
      at_ = after;
      return true;
    }
    // "Next to the bed is a lamp": before any thing of the sentence.
    const bool leads = at_ == sentence_start_ ||
                       (at_ == sentence_start_ + 1 && is_word(sentence_start_, "and")) ||
                       is_inverted(after);
    hear_plural();
    const bool read = read_place_target(placement, after, leads) ||
                      read_thing_target(placement, after, leads) ||
                      (placement.adverb && ends_here(after) && read_implied_target(placement, after));
    talk_.speak_of_one();
    return read;
  }

  // "…, and on the shelf sits a vase": the thing comes after the verb.
  bool is_inverted(std::size_t after) const {
    std::size_t end = after;
    if (const auto place = read_place(tokens_, after, words_))
      end += place->length;
    else if (const auto phrase = read_noun_phrase(tokens_, after, words_, table_, false))
      end = phrase->end;
    if (end == after || end + 1 >= tokens_.size() || !words_.postures.count(tokens_[end].text))
      return false;
    const Token& next = tokens_[end + 1];
    return next.kind == Token::Kind::number ||
           (words_.numbers.count(next.text) > 0 && !words_.definite.count(next.text));
  }

  bool ends_here(std::size_t i) const {
    return i >= tokens_.size() || tokens_[i].kind != Token::Kind::word || is_word(i, "and") ||
           is_word(i, "with") || is_word(i, "while") || words_.verbs.count(tokens_[i].text) > 0;
  }

  // "… are", "… both sit": of all that were listed.
  void hear_plural() {
    std::size_t i = owner_end_;
    while (i < tokens_.size() && is_adverb(tokens_[i])) ++i;
    if (i < tokens_.size() && words_.plural_verbs.count(tokens_[i].text) > 0) talk_.speak_of_all();
  }

  bool read_place_target(const Placement& placement, std::size_t after, bool leads) {
    const auto place = read_place(tokens_, after, words_);
    if (!place || names_thing(after, after + place->length)) return false;
    const std::size_t end = after + place->length;
    // "a desk with a laptop at its center"
    if (place->place == Place::middle && is_word(after, "its")) {
      if (talk_.subject()) talk_.put_on_what_was_named();
      at_ = end;
      return true;
    }
    // "the middle of the table" is on the table.
    if (place->place == Place::middle && is_word(end, "of")) {
      Placement on;
      on.relations = {RelationKind::on};
      return read_thing_target(on, end + 1, leads);
    }
    if (talk_.subject() || leads) talk_.locate(placement, *place, leads);
    at_ = end;
    return true;
  }

  // "a wall-mounted television" is no wall.
  bool names_thing(std::size_t begin, std::size_t end) const {
    const auto phrase = read_noun_phrase(tokens_, begin, words_, table_, false);
    if (!phrase || phrase->kind.length == 0 || phrase->end <= end) return false;
    return std::none_of(tokens_.begin() + static_cast<std::ptrdiff_t>(begin),
                        tokens_.begin() + static_cast<std::ptrdiff_t>(phrase->end),
                        [](const Token& token) {
                          return token.kind == Token::Kind::comma || token.is_word("and");
                        });
  }

  // "to its left", "on top": of what was spoken of before.
  bool read_implied_target(const Placement& placement, std::size_t after) {
    // "Across the room, a wardrobe …"
    const bool leads = at_ == sentence_start_;
    const RelationKind first = placement.relations.front();
    // "chairs with cushions, three on each long side"
    if (first == RelationKind::around && talk_.subject() && talk_.with_owner() &&
        talk_.mention(*talk_.subject()).mount == Mount::surface)
      talk_.speak_of(talk_.with_owner());
    const bool vertical = first == RelationKind::above || first == RelationKind::under;
    auto target = leads ? talk_.last_on_floor() : talk_.antecedent(first);
    if (leads && vertical)
      if (const auto carrier = talk_.last_carrier()) target = carrier;
    // "a stool faces the bench, where a computer is on top", "a board with a knife on top"
    const auto owner = where_ ? where_ : talk_.with_owner();
    const bool on_owner =
        first == RelationKind::on && !leads && owner && owner != talk_.subject();
    if (on_owner) target = owner;
    if ((!talk_.subject() && !leads) || !target) return false;
    if (first == RelationKind::above && is_word(after, "hangs")) talk_.hang_lamps(leads);
    say(placement, *target, leads);
    if (on_owner) talk_.speak_of(target);
    if (leads) talk_.speak_of(std::nullopt);
    at_ = after;
    return true;
  }

  void say(const Placement& placement, std::size_t target, bool leads) {
    if (placement.hanging) talk_.hang_lamps(leads);
    for (auto kind : placement.relations) talk_.demand({kind, target, "", placement.flank}, leads);
  }

  // The things after a placement: "between the sofa and the window" has two.
  bool read_thing_target(const Placement& placement, std::size_t after, bool leads) {
    const auto speaker = talk_.subject();
    if (!speaker && !leads) return false;
    const std::size_t before = talk_.count();
    std::size_t end = skip_portion(after);
    const bool portion = end > after;
    const auto target = read_target(end);
    if (!target || (target == speaker && !leads)) return false;
    last_target_ = target;
    if (speaker && !leads) give_each_one(*speaker, *target, after);
    if (portion && !leads && talk_.mention(*speaker).mount == Mount::surface)
      talk_.demand({RelationKind::on, *target, "", false}, leads);
    else
      say(placement, *target, leads);
    if (tokens_[after - 1].is_word("between") && is_word(end, "and"))
      read_second_target(placement, end, leads);
    at_ = owner_end_ = end;
    // The text goes on about what it has just introduced.
    if (leads) {
      leading_end_ = end;
      talk_.speak_of(std::nullopt);
    } else if (*target >= before) {
      if (talk_.may_carry(*speaker)) talk_.join_with(*speaker);
      talk_.speak_of(target);
    }
    return true;
  }

  // "a lamp on each nightstand": as many as there are nightstands.
  void give_each_one(std::size_t subject, std::size_t target, std::size_t after) {
    const int number = talk_.mention(target).quantity;
    const bool each = is_word(after, "each") || is_word(after, "every");
    if (each && talk_.mention(subject).quantity == 1 && number > 1 && number <= most_for_each)
      talk_.multiply(subject, number);
  }

  void read_second_target(const Placement& placement, std::size_t& end, bool leads) {
    std::size_t second = end + 1;
    if (const auto place = read_place(tokens_, second, words_)) {
      talk_.locate(placement, *place, leads);
      end = second + place->length;
    } else if (const auto other = read_target(second)) {
      say(placement, *other, leads);
      end = second;
    }
  }

  // "the edge of" the bathtub, "one end of" the vanity
  std::size_t skip_portion(std::size_t i) const {
    std::size_t end = i;
    while (end < tokens_.size() && end < i + 3 && !words_.portions.count(tokens_[end].text)) ++end;
    const bool determined = end > i && (words_.definite.count(tokens_[i].text) > 0 ||
                                        words_.numbers.count(tokens_[i].text) > 0);
    return determined && end < i + 3 && is_word(end + 1, "of") ? end + 2 : i;
  }

  // A pronoun or a noun phrase at `end`, which moves behind it.
  std::optional<std::size_t> read_target(std::size_t& end) {
    if (end >= tokens_.size() || (is_word(end, "each") && is_word(end + 1, "other")))
      return std::nullopt;
    if (words_.pronouns.count(tokens_[end].text)) {
      ++end;
      return talk_.antecedent();
    }
    if (const auto carrier = read_top(end)) return carrier;
    const auto phrase = read_noun_phrase(tokens_, end, words_, table_, false);
    if (!phrase) return std::nullopt;
    end = phrase->end;
    // "on a nightstand" means one of those that are there.
    if (phrase->count == 1 && !phrase->another)
      if (const auto known = talk_.known(*phrase)) return known;
    return talk_.refer(*phrase);
  }

  // "the countertop", "its surface": of the table or cabinet that was spoken of.
  std::optional<std::size_t> read_top(std::size_t& end) const {
    if (!words_.definite.count(tokens_[end].text)) return std::nullopt;
    std::size_t i = end + 1;
    // "the vanity countertop", "the wooden surface"
    const bool bare = i < tokens_.size() && words_.tops.count(tokens_[i].text) > 0;
    const KindMention owner = bare ? KindMention() : mention_at(table_, tokens_, i);
    if (!bare && i + 1 < tokens_.size()) i += std::max<std::size_t>(1, owner.length);
    const bool known_owner = owner.length > 0 && talk_.last_of(owner);
    if (i >= tokens_.size() || is_word(i + 1, "of") ||
        !(words_.tops.count(tokens_[i].text) ||
          (known_owner && words_.portions.count(tokens_[i].text))))
      return std::nullopt;
    if (is_word(i + 1, "shelf")) ++i;
    auto carrier = talk_.last_of(owner);
    if (!carrier) carrier = talk_.last_carrier(tokens_[i].text);
    if (carrier) end = i + 1;
    return carrier;
  }

  // "flanked by two lamps", "surrounded by chairs": the subject is the target.
  bool read_inverse(const Placement& placement, std::size_t after) {
    const bool holds = placement.relations.front() == RelationKind::on;
    const auto target = holds ? talk_.holder() : talk_.subject();
    if (!target) return false;
    if (is_word(after, "in") && is_word(after + 1, "total")) after += 2;
    const auto phrase = read_noun_phrase(tokens_, after, words_, table_, true);
    if (!phrase) return false;
    const auto other = refer(*phrase);
    at_ = owner_end_ = phrase->end;
    if (!other || other == target) return true;
    std::vector<std::size_t> others = {*other};
    // "flanked by a dishwasher and a pantry"
    if (placement.flank && is_word(at_, "and"))
      if (const auto second = read_noun_phrase(tokens_, at_ + 1, words_, table_, true);
          second && second->article) {
        if (const auto more = refer(*second); more && more != target) others.push_back(*more);
        at_ = owner_end_ = second->end;
      }
    for (const std::size_t each : others)
      for (auto kind : placement.relations)
        talk_.add(each, {kind, *target, "", placement.flank, others.size() > 1,
                         talk_.holder_number()});
    std::vector<Demand> listed;
    for (auto kind : placement.relations)
      if (!placement.flank)
        listed.push_back({kind, *target, "", false, false, talk_.holder_number()});
    // Flowers may fill a vase; what is listed next is not in it.
    if (!holds || talk_.may_carry(*target)) talk_.open_list(std::move(listed));
    talk_.speak_of(others.back());
    return true;
  }

  // --- What is forbidden, and windows ---------------------------------------------------------

  bool read_bare() {
    const std::size_t end = read_only(tokens_, at_, words_);
    if (end == at_) return false;
    brief_.bare = true;
    at_ = end;
    return true;
  }

  bool read_negation() {
    const auto absence = read_absence(tokens_, at_, words_, table_);
    if (!absence) return false;
    if (absence->windows) brief_.windows = 0;
    auto& excluded = brief_.excluded;
    for (const auto& kind : absence->kinds) {
      const std::string category = talk_.category_name(kind);
      if (std::find(excluded.begin(), excluded.end(), category) == excluded.end())
        excluded.push_back(category);
    }
    at_ = absence->end;
    return true;
  }

  bool read_openings() {
    const auto& kinds = OpeningKinds::built_in();
    if (!kinds) return false;
    const auto phrase = read_opening(tokens_, at_, sentence_start_, words_, table_, *kinds);
    if (!phrase) return false;
    const bool part = is_part_of_owner(*phrase);
    at_ = phrase->end;
    if (part) owner_end_ = at_;
    else ask_for(*phrase, brief_);
    return true;
  }

  // "a wardrobe with sliding doors", "a cabinet with drawers and doors"
  bool is_part_of_owner(const OpeningPhrase& phrase) const {
    if (phrase.wish.type == OpeningType::window || phrase.wish.has_place()) return false;
    if (!talk_.subject() || at_ == 0 || at_ - 1 != owner_end_) return false;
    static const WordSet owners = {"with", "featuring", "has"};
    const bool introduced =
        tokens_[at_].kind == Token::Kind::number || words_.numbers.count(tokens_[at_].text) > 0;
    return owners.count(tokens_[at_ - 1].text) > 0 || !introduced;
  }

  std::vector<Token> tokens_;
  const Vocabulary& words_;
  const KindTable& table_;
  Brief& brief_;
  Discourse talk_;
  std::size_t at_ = 0;
  std::size_t sentence_start_ = 0;
  bool after_part_ = false;    ///< the last phrase was of a part, no thing of its own
  std::optional<std::size_t> last_target_;  ///< of a placement of this sentence
  std::optional<std::size_t> where_;        ///< what a "where" of this sentence speaks of
  std::size_t leading_end_ = 0;  ///< behind the last place told before its thing
  std::size_t owner_end_ = 0;  ///< behind the last phrase about a thing
};

}  // namespace

Brief read_prompt(std::string_view prompt, const RoomKinds& kinds, const KindTable& table) {
  Brief brief;
  const auto& words = built_in_vocabulary();
  if (!words) return brief;
  auto tokens = tokenize(prompt);
  if (tokens.size() >= max_tokens)
    brief.notes.push_back("only the first " + std::to_string(max_tokens) +
                          " words of the prompt were read");
  read_measures(tokens, *words, table, brief);
  read_people(tokens, *words, table, brief);
  read_floor_shape(tokens, *words, table, kinds, brief);
  read_room_type(tokens, *words, table, kinds, brief);
  read_finishes(tokens, *words, table, finish_words(), brief);
  PromptReader(std::move(tokens), {*words, table, kinds.get(brief.type)}, brief).run();
  settle(brief, table);
  if (brief.type.empty() && brief.mentions.empty() && brief.styles.empty() && !prompt.empty())
    brief.notes.push_back(
        "no room and no thing of the prompt is known; the rules read English only (a language model "
        "reads others: --model)");
  if (brief.type.empty()) {
    brief.type = guess_room_type(brief, kinds, table);
    if (!brief.type.empty()) {
      brief.type_known = true;
      brief.notes.push_back("the prompt names no kind of room; taken for a " + brief.type);
    }
  }
  return brief;
}

}  // namespace roomgen::design
