// Noun phrases that name a thing or a part.
#include <algorithm>
#include <utility>

#include "language/inflection.h"
#include "part_forms.h"
#include "phrase_reader.h"
#include "phrase_text.h"

namespace roomgen::create {

using language::Attachment;
using language::Determiner;
using language::none;
using language::NounPhrase;
using language::VerbPhrase;

namespace {

constexpr std::size_t most_objects = 8;
constexpr int usual_some = 3;  // of things named in the plural without a number

}  // namespace

// The first that is of a known kind and stands for itself; else the first noun.
std::size_t PhraseReader::find_head() const {
  for (std::size_t i = 0; i < parse_.phrases.size(); ++i)
    if (stands_alone(i) && text_.kind(phrase(i)) && !is_arranged(i)) return i;
  for (std::size_t i = 0; i < parse_.phrases.size(); ++i)
    if (stands_alone(i) && !is_arranged(i)) return i;
  return parse_.phrases.size();
}

bool PhraseReader::stands_alone(std::size_t i) const {
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

bool PhraseReader::says_nothing(const NounPhrase& said) const {
  return words_.fillers.count(text_[said.head]) > 0 && text_.content(said) == said.head;
}

// "stack twenty rings": the parts, not the thing.
bool PhraseReader::is_arranged(std::size_t i) const {
  const auto id = static_cast<std::int32_t>(i);
  return std::any_of(parse_.verbs.begin(), parse_.verbs.end(), [&](const VerbPhrase& verb) {
    return verb.object == id && words_.arrangements.count(verb.base);
  });
}

// The head: what the sentence describes.
void PhraseReader::name_thing(std::size_t i) {
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
std::size_t PhraseReader::noun_begin(std::size_t i) const {
  std::size_t at = text_.content(phrase(i));
  Attributes unused;
  while (at < phrase(i).head)
    if (const std::size_t length = text_.read_attribute(at, phrase(i).head, unused))
      at += length;
    else
      break;
  return at;
}

void PhraseReader::add_object(std::size_t i, const PhraseText::Match<const ShapeKind*>& kind) {
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
bool PhraseReader::tells_use(std::size_t i) const {
  const Attachment* joint = joins(i);
  return joint && joint->from == static_cast<std::int32_t>(head_) &&
         (joint->relation == "of" || !words_.owners.count(joint->relation));
}

// A part, or another thing beside the first.
void PhraseReader::name_other(std::size_t i) {
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
bool PhraseReader::has_relation(std::size_t i) const {
  return std::any_of(words_.relations.begin(), words_.relations.end(), [&](const auto& relation) {
    return text_.starts(phrase(i).tokens.end, relation.first);
  });
}

// A noun that nobody knows is a part where parts are introduced; "three crests long" is a
// measure.
bool PhraseReader::is_unknown_part(std::size_t i) const {
  const NounPhrase& said = phrase(i);
  const bool introduced =
      said.determiner == Determiner::indefinite || said.count > 0 || said.is_denied;
  const std::string noun = language::singular(text_[said.head]);
  const bool is_measure =
      said.head + 1 < said.tokens.end && words_.scales.count(text_[said.head + 1]);
  return introduced && !is_measure && (is_owned(i) || place_) && !words_.fillers.count(noun) &&
         may_be_part(noun);
}

void PhraseReader::name_part(std::size_t i, const std::string& label, std::size_t begin, std::size_t end) {
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
bool PhraseReader::is_left_out(std::size_t i) const {
  return std::any_of(parse_.verbs.begin(), parse_.verbs.end(), [&](const VerbPhrase& verb) {
    return verb.object == static_cast<std::int32_t>(i) &&
           (words_.absences.count(verb.base) ||
            words_.absences.count(verb.base + " " + text_[phrase(i).tokens.end]));
  });
}

}  // namespace roomgen::create
