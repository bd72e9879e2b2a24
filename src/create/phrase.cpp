#include <algorithm>
#include <utility>

#include "language/number.h"
#include "phrase_reader.h"
#include "phrase_text.h"
#include "rule_steps.h"

namespace roomgen::create {

using language::Attachment;
using language::none;
using language::NounPhrase;

std::vector<Description> PhraseReader::run() {
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

const Attachment* PhraseReader::joins(std::size_t i) const {
  const auto found =
      std::find_if(parse_.attachments.begin(), parse_.attachments.end(),
                   [&](const Attachment& one) { return one.to == static_cast<std::int32_t>(i); });
  return found == parse_.attachments.end() ? nullptr : &*found;
}

// "with", "has", a list or nothing: what the phrase names belongs to what was named.
bool PhraseReader::is_owned(std::size_t i) const {
  const std::string relation = relation_to(i);
  return relation.empty() || words_.owners.count(relation) > 0;
}

// What stands at a token is said of: the subject of its verb, what its preposition belongs to, or
// what was named last.
Referent PhraseReader::subject_at(std::size_t token) const {
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

void PhraseReader::read_phrase(std::size_t i) {
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
Attributes PhraseReader::attributes(std::size_t i, std::size_t name_begin, std::size_t name_end,
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
std::size_t PhraseReader::read_owned(std::size_t at, std::size_t end, std::vector<NamedPart>* owned) {
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

void PhraseReader::measure_of(const NounPhrase& said, const Referent& of) {
  if (said.measure != none)
    objects_.measure(parse_.measures[static_cast<std::size_t>(said.measure)], of);
}

std::vector<Description> read_phrase(const std::string& prompt, const Words& words,
                                     const ShapeKinds& kinds) {
  return PhraseReader(prompt, words, kinds).run();
}

}  // namespace roomgen::create
