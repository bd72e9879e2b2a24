// Noun phrases that name nothing new: they stand for what was named, or say what it is like.
#include <algorithm>
#include <utility>

#include "language/inflection.h"
#include "phrase_reader.h"

namespace roomgen::create {

using language::Attachment;
using language::Determiner;
using language::none;
using language::NounPhrase;

// "three on either side", "two of them", "two little ones".
void PhraseReader::stand_for(std::size_t i) {
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
void PhraseReader::count_first(int count) {
  if (!objects_.head()) return;
  auto& parts = objects_.head()->parts;
  const auto first = std::find_if(parts.begin(), parts.end(), [](const PartWish& part) {
    return !part.label.empty() && !part.count;
  });
  if (first != parts.end()) first->count = count;
}

// "a door on three of them"
void PhraseReader::count_some(std::size_t i, int count) {
  const Attachment* joint = joins(i);
  // "two of them mirrored"
  if (!joint || joint->from == none || is_owned(i))
    return void((pending_.count = count, pending_.article = true));
  if (PartWish* part = objects_.part(named_[static_cast<std::size_t>(joint->from)]))
    part->count = count * part->count.value_or(1);
}

void PhraseReader::read_likeness(std::size_t i) {
  const NounPhrase& said = phrase(i);
  Attributes all, form;
  for (std::size_t at = said.tokens.begin; at < said.tokens.end; ++at)
    text_.read_attribute(at, at + 1, all);
  form.shape = all.shape;
  form.course = all.course;
  objects_.apply(form, target_);
}

std::optional<Referent> PhraseReader::subject_of_being(std::size_t i) const {
  for (const auto& verb : parse_.verbs)
    if (verb.object == static_cast<std::int32_t>(i) && verb.base == "be" && verb.subject != none)
      if (const auto& subject = named_[static_cast<std::size_t>(verb.subject)]) return subject;
  return std::nullopt;
}

void PhraseReader::read_predicate(std::size_t i) {
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
void PhraseReader::specialise(std::size_t i) {
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

}  // namespace roomgen::create
