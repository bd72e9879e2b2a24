#include "phrase.h"

#include <algorithm>

#include "language/inflection.h"
#include "language/number.h"
#include "part_forms.h"
#include "phrase_measure.h"
#include "phrase_objects.h"
#include "phrase_place.h"
#include "phrase_text.h"
#include "roomgen/base/text.h"

namespace roomgen::create {

namespace {

using language::Attachment;
using language::Determiner;
using language::none;
using language::NounPhrase;
using language::VerbPhrase;

constexpr std::size_t most_objects = 8;
constexpr int usual_some = 3;  // of things named in the plural without a number

/// Reads the parse of a sentence from its first word to its last: noun phrases name things and
/// parts, which the attachments join; what stands between them is said of what was named before, or
/// of the subject of its verb.
class PhraseReader {
 public:
  PhraseReader(const std::string& prompt, const Words& words, const ShapeKinds& kinds)
      : words_(words),
        kinds_(kinds),
        text_(prompt, words, *built_in_parts(), kinds),
        parse_(text_.parse()),
        objects_(prompt, kinds),
        named_(parse_.phrases.size()) {}

  std::vector<Description> run() {
    head_ = find_head();
    std::size_t next = 0;
    while (at_ < text_.size()) {
      while (next < parse_.phrases.size() && parse_.phrases[next].tokens.end <= at_) ++next;
      const bool is_phrase =
          next < parse_.phrases.size() && parse_.phrases[next].tokens.begin <= at_;
      if (phrase_of_place() || simile() || (is_phrase && measure())) continue;
      if (is_phrase)
        read_phrase(next);
      else
        read_between();
    }
    release();
    return objects_.finish();
  }

 private:
  const NounPhrase& phrase(std::size_t i) const { return parse_.phrases[i]; }

  // --- What joins phrases -----------------------------------------------------------------------

  const Attachment* joins(std::size_t i) const {
    const auto found =
        std::find_if(parse_.attachments.begin(), parse_.attachments.end(),
                     [&](const Attachment& one) { return one.to == static_cast<std::int32_t>(i); });
    return found == parse_.attachments.end() ? nullptr : &*found;
  }
  std::string relation_to(std::size_t i) const {
    const Attachment* joint = joins(i);
    return joint ? joint->relation : "";
  }
  // "with", "has", a list or nothing: what the phrase names belongs to what was named.
  bool is_owned(std::size_t i) const {
    const std::string relation = relation_to(i);
    return relation.empty() || words_.owners.count(relation) > 0;
  }
  // What stands at a token is said of: the subject of its verb, what its preposition belongs to, or
  // what was named last.
  Referent subject_at(std::size_t token) const {
    const auto holds = [&](const language::Run& run) {
      return run.begin <= token && token < run.end;
    };
    for (const auto& verb : parse_.verbs) {
      bool is_said = holds(verb.tokens);
      for (auto i = verb.complement.begin; i < verb.complement.end; ++i)
        is_said |= holds(parse_.modifiers[i].tokens);
      if (is_said && verb.subject != none)
        if (const Referent subject = named_[static_cast<std::size_t>(verb.subject)]) return subject;
    }
    for (const auto& attachment : parse_.attachments)
      if (holds(attachment.tokens) && attachment.from != none)
        if (const Referent from = named_[static_cast<std::size_t>(attachment.from)]) return from;
    return last_;
  }

  // --- The thing itself -------------------------------------------------------------------------

  // The first that is of a known kind and stands for itself; else the first noun.
  std::size_t find_head() const {
    for (std::size_t i = 0; i < parse_.phrases.size(); ++i)
      if (stands_alone(i) && text_.kind(phrase(i)) && !is_arranged(i)) return i;
    for (std::size_t i = 0; i < parse_.phrases.size(); ++i)
      if (stands_alone(i) && !is_arranged(i)) return i;
    return parse_.phrases.size();
  }
  bool stands_alone(std::size_t i) const {
    const NounPhrase& said = phrase(i);
    if (said.is_pronoun || says_nothing(said)) return false;
    if (text_.is_attribute(said) && said.determiner == Determiner::absent &&
        parse_.phrases.size() > 1)
      return false;
    const Attachment* joint = joins(i);
    return !joint ||
           (joint->from != none && (phrase(static_cast<std::size_t>(joint->from)).is_pronoun ||
                                    says_nothing(phrase(static_cast<std::size_t>(joint->from))))) ||
           joint->relation == "into";
  }
  bool says_nothing(const NounPhrase& said) const {
    return words_.fillers.count(text_[said.head]) > 0 && text_.content(said) == said.head;
  }
  // "stack twenty rings": the parts, not the thing.
  bool is_arranged(std::size_t i) const {
    const auto id = static_cast<std::int32_t>(i);
    return std::any_of(parse_.verbs.begin(), parse_.verbs.end(), [&](const VerbPhrase& verb) {
      return verb.object == id && words_.arrangements.count(verb.base);
    });
  }

  // --- Noun phrases -----------------------------------------------------------------------------

  void read_phrase(std::size_t i) {
    const NounPhrase& said = phrase(i);
    const std::size_t end = std::max<std::size_t>(said.tokens.end, text_.last_word(said) + 1);
    if (objects_.empty() && i == head_) {
      name_thing(i);
    } else if (said.is_pronoun || says_nothing(said)) {
      stand_for(i);
    } else if (likeness_) {
      read_likeness(i);
    } else if (words_.purposes.count(relation_to(i))) {
      specialise(i);
    } else if (words_.comparisons.count(relation_to(i))) {
      target_ = subject_at(joins(i)->tokens.begin);
      read_likeness(i);
    } else if (is_predicate(i) || text_.is_attribute(said)) {
      read_predicate(i);
    } else if (!arrange(i)) {
      name_other(i);
    }
    at_ = std::max(at_, end);
    likeness_ = false;
    if (!text_.is(at_, ",") && !text_.is(at_, "and") && !pending_.article && !is_arrangement(i))
      place_ = nullptr;
  }

  // The words around the name: `owned` gets parts that modifiers name.
  Attributes attributes(std::size_t i, std::size_t name_begin, std::size_t name_end,
                        std::vector<NamedPart>* owned) {
    const NounPhrase& said = phrase(i);
    Attributes read = std::exchange(pending_, {});
    const auto carried = read.count;
    for (std::size_t at = said.tokens.begin; at < said.tokens.end;) {
      if (at >= name_begin && at < name_end)
        at = name_end;
      else if (const std::size_t length = read_owned(at, name_begin, owned))
        at += length;
      else if (const auto measure = read_measure(text_, at))
        at += measure->length;
      else
        at += std::max<std::size_t>(
            1, text_.read_attribute(at, at < name_begin ? name_begin : said.tokens.end, read));
    }
    read.count = count_of(said) ? count_of(said) : carried;
    if (!read.count && said.count == 1 && text_.is(text_.content(said), "single")) read.count = 1;
    return read;
  }
  // "three-legged": a modifier of several words that names a part, or a part alone.
  std::size_t read_owned(std::size_t at, std::size_t end, std::vector<NamedPart>* owned) {
    if (!owned || at >= end) return 0;
    const auto number = language::number_at(parse_.tokens, at);
    std::size_t next = at + (number ? number->length : 0);
    NamedPart named;
    if (number)
      named.said.count = static_cast<int>(number->value);
    else if (next + 1 < end && parse_.tokens[next + 1].joint == language::Token::Joint::hyphen)
      next += text_.read_attribute(next, next + 1, named.said);
    const auto part = text_.owned_part(next, end);
    Attributes unused;
    // "framed" alone is what the thing is like.
    if (!part || (next == at && text_[at].ends_with("ed")) ||
        (next == at && text_.read_attribute(at, end, unused) > 0))
      return 0;
    named.label = part.meaning;
    owned->push_back(named);
    return part.end - at;
  }

  void measure_of(const NounPhrase& said, const Referent& of) {
    if (said.measure != none)
      objects_.measure(parse_.measures[static_cast<std::size_t>(said.measure)], of);
  }

  // The head: what the sentence describes.
  void name_thing(std::size_t i) {
    const NounPhrase& said = phrase(i);
    if (arrange(i)) return;
    const auto kind = text_.kind(said);
    if (kind) return void(add_object(i, kind));
    std::vector<NamedPart> owned;
    const std::size_t begin = noun_begin(i), end = text_.last_word(said) + 1;
    const auto part = text_.part(said, nullptr);
    const Attributes read = attributes(i, begin, end, &owned);
    for (const auto& one : owned) objects_.add_part(one);
    // "a tower with four windows": no other thing is named, so the part is the thing.
    if (part && part.begin == begin) {
      objects_.add_part({part.meaning, read, false, said.determiner == Determiner::indefinite});
      last_ = named_[i] = {objects_.add_unknown(part.meaning, {}).object, part.meaning};
    } else {
      last_ = named_[i] = objects_.add_unknown(text_.joined(begin, end), read);
    }
    measure_of(said, last_);
  }
  // Adjectives that are known are no part of a name.
  std::size_t noun_begin(std::size_t i) const {
    std::size_t at = text_.content(phrase(i));
    Attributes unused;
    while (at < phrase(i).head)
      if (const std::size_t length = text_.read_attribute(at, phrase(i).head, unused))
        at += length;
      else
        break;
    return at;
  }

  void add_object(std::size_t i, const PhraseText::Match<const ShapeKind*>& kind) {
    const NounPhrase& said = phrase(i);
    std::vector<NamedPart> owned;
    Description object;
    object.noun = text_.joined(kind.begin, kind.end);
    object.kind = kind.meaning->name;
    // "cups on it": some of them.
    if (!objects_.empty() && said.is_plural) object.count = usual_some;
    // "a sculpture of three spheres" is what its parts are.
    if (objects_.empty() && words_.makings.count(object.noun) &&
        (text_.is(kind.end, "of") || text_.is(kind.end, "from"))) {
      object.kind.clear();
      object.approximate = true;
    }
    const Attributes read =
        attributes(i, kind.begin, kind.end, objects_.empty() ? &owned : nullptr);
    for (const auto& one : owned) objects_.add_part(one);
    last_ = named_[i] = objects_.add(std::move(object), read);
    measure_of(said, last_);
    at_ = std::max(at_, kind.end);
  }

  // "a rack that holds towels", "a chest of drawers"
  bool tells_use(std::size_t i) const {
    const Attachment* joint = joins(i);
    return joint && joint->from == static_cast<std::int32_t>(head_) &&
           (joint->relation == "of" || !words_.owners.count(joint->relation));
  }

  // A part, or another thing beside the first.
  void name_other(std::size_t i) {
    const NounPhrase& said = phrase(i);
    if (tells_use(i)) specialise(i);
    const auto part = text_.part(said, objects_.head());
    const auto kind = text_.kind(said);
    const bool has = part && text_.has_part(objects_.head(), part.meaning);
    const bool made_of_parts = !objects_.empty() && objects_.head()->kind.empty();
    const bool ends = part && part.begin + part.length() > text_.last_word(said);
    const bool longer = kind && part && kind.length() > part.length() && !has && !made_of_parts;
    if (ends && !(kind && has_relation(i)) && !longer)
      return name_part(i, part.meaning, part.begin, part.end);
    if (objects_.empty()) return;
    if (kind && !said.is_denied && kind.meaning->name != objects_.head()->kind &&
        objects_.size() < most_objects) {
      if (is_owned(i) || has_relation(i))
        add_object(i, kind);
      else
        pending_ = {};
      return;
    }
    if (!kind && is_unknown_part(i))
      name_part(i, language::singular(text_[said.head]), said.head, said.head + 1);
    else
      pending_ = {};
  }
  // "cups on it"
  bool has_relation(std::size_t i) const {
    return std::any_of(words_.relations.begin(), words_.relations.end(), [&](const auto& relation) {
      return text_.starts(phrase(i).tokens.end, relation.first);
    });
  }
  // A noun that nobody knows is a part where parts are introduced; "three crests long" is a
  // measure.
  bool is_unknown_part(std::size_t i) const {
    const NounPhrase& said = phrase(i);
    const bool introduced =
        said.determiner == Determiner::indefinite || said.count > 0 || said.is_denied;
    const std::string noun = language::singular(text_[said.head]);
    const bool is_measure =
        said.head + 1 < said.tokens.end && words_.scales.count(text_[said.head + 1]);
    return introduced && !is_measure && (is_owned(i) || place_) && !words_.fillers.count(noun) &&
           may_be_part(noun);
  }

  void name_part(std::size_t i, const std::string& label, std::size_t begin, std::size_t end) {
    const NounPhrase& said = phrase(i);
    const bool has = text_.has_part(objects_.head(), label);
    const bool is_subject = std::any_of(
        parse_.verbs.begin(), parse_.verbs.end(),
        [&](const VerbPhrase& verb) { return verb.subject == static_cast<std::int32_t>(i); });
    const bool gone = is_left_out(i);
    if (!objects_.empty() && !is_owned(i) && !place_ && !is_subject && !gone &&
        !(has && said.determiner != Determiner::definite)) {
      pending_ = {};
      return;
    }
    // "on a pedestal": how it is built.
    const auto built = words_.constructions.find(text_[said.head]);
    const bool is_built = built != words_.constructions.end();
    if (is_built && place_ && place_->below && !objects_.empty()) {
      Attributes construction;
      construction.construction = built->second;
      objects_.apply(construction, {0, ""});
      if (!has) return;
    }
    NamedPart named{label, attributes(i, begin, end, nullptr), said.is_denied,
                    said.determiner == Determiner::indefinite && !said.is_plural};
    last_ = named_[i] = objects_.add_part(named);
    PartWish* part = objects_.part(last_);
    // "above the top": that is there already.
    if (part && place_ && !(has && (place_->below || said.determiner == Determiner::definite)))
      place_after(*place_, *part);
    measure_of(said, last_);
    if (part && gone) part->count = 0;
  }
  // "leave the armrests out"
  bool is_left_out(std::size_t i) const {
    return std::any_of(parse_.verbs.begin(), parse_.verbs.end(), [&](const VerbPhrase& verb) {
      return verb.object == static_cast<std::int32_t>(i) &&
             (words_.absences.count(verb.base) ||
              words_.absences.count(verb.base + " " + text_[phrase(i).tokens.end]));
    });
  }

  // --- Phrases that name nothing new ------------------------------------------------------------

  // "three on either side", "two of them", "two little ones".
  void stand_for(std::size_t i) {
    const NounPhrase& said = phrase(i);
    PartWish* part = objects_.part(last_);
    if (text_.is(said.head, "ones") && part && pending_.count)
      part->count = part->count.value_or(0) + *std::exchange(pending_, {}).count;
    const std::size_t end = said.tokens.end;
    if (const auto count = count_of(said)) {
      if (text_.is(end, "in") && (text_.is(end + 1, "all") || text_.is(end + 1, "total")))
        return count_first(*count);
      if (text_.is(end, "of") && (text_.is(end + 1, "them") || text_.is(end + 1, "these")))
        return count_some(i, *count);
      // "hooks, thirteen", "drawers, three on either side"
      if (part && text_.is(said.tokens.begin - 1, ",") && said.modifiers.empty() &&
          !text_.is(end, "of")) {
        part->count = *count;
        named_[i] = last_;
        return;
      }
      if (joins(i) && !place_ && !is_owned(i)) return;
      pending_.count = *count;
      pending_.article = true;
      for (std::size_t at = said.tokens.begin; at < end; ++at)
        text_.read_attribute(at, end, pending_);
    }
    if (part) named_[i] = last_;
  }
  // "nine in all": of the first part without a number.
  void count_first(int count) {
    if (!objects_.head()) return;
    auto& parts = objects_.head()->parts;
    const auto first = std::find_if(parts.begin(), parts.end(), [](const PartWish& part) {
      return !part.label.empty() && !part.count;
    });
    if (first != parts.end()) first->count = count;
  }
  // "a door on three of them"
  void count_some(std::size_t i, int count) {
    const Attachment* joint = joins(i);
    // "two of them mirrored"
    if (!joint || joint->from == none || is_owned(i))
      return void((pending_.count = count, pending_.article = true));
    if (PartWish* part = objects_.part(named_[static_cast<std::size_t>(joint->from)]))
      part->count = count * part->count.value_or(1);
  }

  void read_likeness(std::size_t i) {
    const NounPhrase& said = phrase(i);
    Attributes all, form;
    for (std::size_t at = said.tokens.begin; at < said.tokens.end; ++at)
      text_.read_attribute(at, at + 1, all);
    form.shape = all.shape;
    form.course = all.course;
    objects_.apply(form, target_);
  }

  // "legs that are boards", "the seat is a wave": said of the subject.
  bool is_predicate(std::size_t i) const { return subject_of_being(i).has_value(); }
  std::optional<Referent> subject_of_being(std::size_t i) const {
    for (const auto& verb : parse_.verbs)
      if (verb.object == static_cast<std::int32_t>(i) && verb.base == "be" && verb.subject != none)
        if (const auto& subject = named_[static_cast<std::size_t>(verb.subject)]) return subject;
    return std::nullopt;
  }
  void read_predicate(std::size_t i) {
    const NounPhrase& said = phrase(i);
    const auto subject = subject_of_being(i);
    Referent of = subject ? *subject : last_;
    if (const Attachment* joint = joins(i);
        !subject && joint && joint->from != none && !joint->is_verb && joint->relation != "with")
      if (const Referent from = named_[static_cast<std::size_t>(joint->from)]) of = from;
    Attributes read = attributes(i, said.tokens.end, said.tokens.end, nullptr);
    if (said.is_denied) return;
    // "a square padded seat", whose noun is still to come.
    const bool goes_on =
        !subject && said.determiner == Determiner::indefinite && !text_.is(said.tokens.end, ",");
    if (goes_on) {
      pending_ = read;
      pending_.article = true;
      return;
    }
    if (of)
      objects_.apply(read, named_[i] = of);
    else
      pending_ = read;
  }

  // "a stand for umbrellas" is an umbrella stand.
  void specialise(std::size_t i) {
    if (objects_.size() != 1) return;
    Description& object = *objects_.head();
    const std::size_t last = phrase(i).head;
    for (std::size_t at = text_.content(phrase(i)); at <= last; ++at) {
      const std::string held =
          (at < last ? text_.joined(at, last) + " " : "") + language::singular(text_[last]);
      const ShapeKind* kind = kinds_.find(held + " " + object.noun);
      if (!kind) continue;
      object.kind = kind->name;
      object.approximate = false;
      return;
    }
  }

  // "a ring of twelve stones", "stack twenty rings": the word is no thing beside them.
  bool arrange(std::size_t i) {
    const NounPhrase& said = phrase(i);
    const auto found = words_.arrangements.find(text_[said.head]);
    const std::size_t next = i + 1;
    if (found == words_.arrangements.end()) return false;
    if (relation_to(i) == "in") return true;  // "in a row"
    if (next >= parse_.phrases.size() || relation_to(next) != "of" ||
        !(count_of(phrase(next)) || text_.part(phrase(next), nullptr)))
      return false;
    arrange(found->second, text_[said.head]);
    named_[i] = last_;
    at_ = said.tokens.end + 1;
    return true;
  }
  bool is_arrangement(std::size_t i) const {
    return words_.arrangements.count(text_[phrase(i).head]) > 0;
  }
  void arrange(Place place, const std::string& noun) {
    arranged_ = Placement{};
    arranged_.after = place;
    place_ = &arranged_;
    if (!objects_.empty()) return;
    last_ = objects_.add_unknown(noun, std::exchange(pending_, {}));
    objects_.head()->kind.clear();
  }

  // --- Between noun phrases ---------------------------------------------------------------------

  // What was said between phrases belongs to what was named before.
  void release() {
    if (PartWish* part = objects_.part(target_); part && pending_.count && part->count == 0)
      pending_.count.reset();
    if (target_) objects_.apply(std::exchange(pending_, {}), target_);
    target_ = last_;
  }

  // "on three stones", "a handle at each end", "each smaller than the one below", "around it".
  bool phrase_of_place() {
    for (const auto& [relation, meaning] : words_.relations)
      if (text_.starts(at_, relation)) {
        relate(meaning);
        at_ += relation.size();
        return true;
      }
    const Placement* placement = placement_at(text_, at_, words_);
    if (!placement || (objects_.empty() && !placement->opens())) return false;
    if (placement->opens() && !starts_phrase(at_ + placement->words.size())) return false;
    target_ = subject_at(at_);
    if (pending_.article) target_ = last_;
    release();
    const Referent before = subject_at(at_);
    at_ += placement->words.size();
    place_ = placement->opens() ? placement : nullptr;
    PartWish* part = objects_.part(before);
    if (!part) part = objects_.part(last_);
    if (!part) return true;
    place_before(*placement, *part);
    if (placement->series.turn > 0)
      if (const double turn = read_turn(text_, at_); turn > 0) part->series.turn = turn;
    return true;
  }
  bool starts_phrase(std::size_t token) const {
    return std::any_of(parse_.phrases.begin(), parse_.phrases.end(),
                       [&](const NounPhrase& phrase) { return phrase.tokens.begin == token; });
  }
  void relate(const std::string& relation) {
    const Referent of = subject_at(at_);
    if (of && of.object > 0)
      objects_.relate(of.object, relation);
    else if (PartWish* part = objects_.part(of))
      part->place = place_of(relation);
  }

  // "shaped like a tree": no tree is there.
  bool simile() {
    for (const auto& phrase : words_.similes) {
      if (!text_.starts(at_, phrase)) continue;
      release();
      target_ = subject_at(at_);
      at_ += phrase.size();
      likeness_ = true;
      return true;
    }
    return false;
  }

  bool measure() {
    const auto measure = read_measure(text_, at_);
    if (!measure) return false;
    // Behind a comma it is said of the thing, unless it goes on.
    const bool is_of_whole =
        at_ > 0 && text_.is(at_ - 1, ",") && at_ != measured_ + 1 && objects_.head();
    objects_.measure(*measure, is_of_whole ? Referent{0, ""} : subject_at(at_));
    measured_ = at_ += measure->length;
    return true;
  }

  void read_between() {
    if (measure()) return;
    if (const auto stacked = words_.arrangements.find(text_[at_]);
        stacked != words_.arrangements.end() && objects_.empty()) {
      arrange(stacked->second, text_[at_++]);
      return;
    }
    if (const auto part = text_.owned_part(at_, at_ + 1);
        part && pending_.count && !objects_.empty()) {
      last_ = objects_.add_part({part.meaning, std::exchange(pending_, {})});
      ++at_;
      return;
    }
    if (!pending_.article) target_ = subject_at(at_);
    if (const std::size_t length = text_.read_attribute(at_, text_.size(), pending_)) {
      at_ += length;
      if (target_ && !pending_.article) objects_.apply(std::exchange(pending_, {}), target_);
      return;
    }
    if (words_.absences.count(text_[at_]))
      if (PartWish* part = objects_.part(last_)) part->count = 0;
    const bool goes_on = text_.is(at_, "and") || text_.is(at_, "of");
    if (!goes_on) release();
    if (!goes_on && !text_.is(at_, ",")) place_ = nullptr;
    ++at_;
  }

  const Words& words_;
  const ShapeKinds& kinds_;
  PhraseText text_;
  const language::Parse& parse_;
  PhraseObjects objects_;
  std::vector<Referent> named_;  ///< by noun phrase
  std::size_t head_ = 0;         ///< the noun phrase that names the thing itself
  std::size_t at_ = 0;
  std::size_t measured_ = 0;          ///< where the last measure ended
  Referent last_;                     ///< what was named last
  Referent target_;                   ///< of what is pending
  Attributes pending_;                ///< said, and not yet of anything
  const Placement* place_ = nullptr;  ///< says where the parts to come are
  Placement arranged_;                ///< of the last arrangement
  bool likeness_ = false;             ///< what comes is only compared with
};

}  // namespace

std::vector<Description> read_phrase(const std::string& prompt, const Words& words,
                                     const ShapeKinds& kinds) {
  return PhraseReader(prompt, words, kinds).run();
}

}  // namespace roomgen::create
