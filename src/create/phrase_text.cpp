#include "phrase_text.h"

#include <algorithm>

#include "language/inflection.h"
#include "language/lexicon.h"
#include "language/number.h"
#include "roomgen/base/text.h"
#include "shape/color.h"

namespace roomgen::create {

using language::NounPhrase;
using language::Token;

PhraseText::PhraseText(const std::string& prompt, const Words& words, const PartForms& parts,
                       const ShapeKinds& kinds)
    : words_(words),
      parts_(parts),
      kinds_(kinds),
      parse_(language::parse(prompt,
                             [&](std::string_view name) { return kinds.find(name) != nullptr; })) {
  for (const auto& token : parse_.tokens)
    texts_.push_back(token.kind == Token::Kind::word || token.kind == Token::Kind::number
                         ? token.text
                         : std::string(1, ','));
}

const std::string& PhraseText::operator[](std::size_t at) const {
  static const std::string nothing;
  return at < size() ? texts_[at] : nothing;
}

bool PhraseText::starts(std::size_t at, const std::vector<std::string>& phrase) const {
  return at + phrase.size() <= size() &&
         std::equal(phrase.begin(), phrase.end(), texts_.begin() + static_cast<std::ptrdiff_t>(at));
}

std::string PhraseText::joined(std::size_t begin, std::size_t end) const {
  const auto first = texts_.begin();
  return join(
      {first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(end)}, " ");
}

// --- Nouns --------------------------------------------------------------------------------------

std::size_t PhraseText::content(const NounPhrase& phrase) const {
  const bool modified = !phrase.modifiers.empty();
  const std::size_t first =
      modified ? parse_.modifiers[phrase.modifiers.begin].tokens.begin : phrase.head;
  return std::min<std::size_t>(first, phrase.head);
}

std::size_t PhraseText::last_word(const NounPhrase& phrase) const {
  const std::size_t next = phrase.head + 1;
  const auto holds = [&](const auto& part) {
    return part.tokens.begin <= next && next < part.tokens.end;
  };
  const bool is_taken = next >= size() || next < phrase.tokens.end ||
                        !parts_.labels.count(texts_[next]) ||
                        std::any_of(parse_.phrases.begin(), parse_.phrases.end(), holds) ||
                        std::any_of(parse_.verbs.begin(), parse_.verbs.end(), holds) ||
                        std::any_of(parse_.attachments.begin(), parse_.attachments.end(), holds);
  return is_taken ? phrase.head : next;
}

// What is said of its form or style stands before a name: "a round table" is a table.
PhraseText::Match<const ShapeKind*> PhraseText::kind(const NounPhrase& phrase) const {
  for (std::size_t at = content(phrase); at <= phrase.head; ++at) {
    if (at < phrase.head && (words_.shapes.count(texts_[at]) || words_.styles.count(texts_[at])))
      continue;
    const ShapeKind* kind = nullptr;
    const std::size_t length = kinds_.match(texts_, at, &kind);
    if (at + length > last_word(phrase)) return {at, at + length, kind};
  }
  return {};
}

PhraseText::Match<std::vector<std::string>> PhraseText::labels(std::size_t begin,
                                                               std::size_t end) const {
  for (std::size_t at = begin + most_run < end ? end - most_run : begin; at < end; ++at)
    if (const auto found = parts_.labels.find(joined(at, end)); found != parts_.labels.end())
      return {at, end, found->second};
  return {};
}

bool PhraseText::has_part(const Description* head, const std::string& label) const {
  const ShapeKind* kind = head ? kinds_.find(head->kind) : nullptr;
  return kind && kinds_.labels(kind->recipe).count(label) > 0;
}

PhraseText::Match<std::string> PhraseText::part(const NounPhrase& phrase,
                                                const Description* head) const {
  const std::size_t begin = content(phrase), last = last_word(phrase);
  Match<std::string> first;
  for (std::size_t at = last + 1; at-- > begin;) {
    const auto known = labels(begin, at + 1);
    for (const auto& label : known.meaning)
      if (has_part(head, label)) return {known.begin, last + 1, label};
    // Recipes have parts of which no list knows.
    if (const auto label = language::singular(texts_[at]); has_part(head, label))
      return {at, last + 1, label};
    if (known && at == last) first = {known.begin, known.end, known.meaning.front()};
  }
  return first;
}

PhraseText::Match<std::string> PhraseText::owned_part(std::size_t at, std::size_t end) const {
  if (const auto found = longest(parts_.labels, at, end))
    return {found.begin, found.end, found.meaning->front()};
  // "three-legged"
  std::string stem = (*this)[at];
  if (stem.size() <= 4 || !stem.ends_with("ed")) return {};
  stem.resize(stem.size() - 2);
  if (stem[stem.size() - 1] == stem[stem.size() - 2]) stem.pop_back();
  const auto found = parts_.labels.find(stem);
  if (found == parts_.labels.end()) return {};
  return {at, at + 1, found->second.front()};
}

// --- Attributes ---------------------------------------------------------------------------------

// One word may say several things of a form: "splayed" is a way to build legs and a lean.
std::size_t PhraseText::read_form(std::size_t at, std::size_t end, Attributes& to) const {
  const auto construction = longest(words_.constructions, at, end);
  const auto lean = longest(words_.leans, at, end);
  const auto course = longest(words_.courses, at, end);
  const auto shape = longest(words_.shapes, at, end);
  if (construction) to.construction = *construction.meaning;
  if (lean) to.lean = *lean.meaning;
  if (course) to.course = *course.meaning;
  if (shape) to.shape = *shape.meaning;
  // The last that is known says how far it goes.
  for (const std::size_t length : {shape.length(), course.length(), lean.length()})
    if (length > 0) return length;
  return construction.length();
}

std::size_t PhraseText::read_attribute(std::size_t at, std::size_t end, Attributes& to) const {
  if (const auto strength = longest(words_.strengths, at, end)) {
    to.strength = *strength.meaning;
    return strength.length();
  }
  if (const auto style = longest(words_.styles, at, end)) {
    to.style = *style.meaning;
    return style.length();
  }
  if (const std::size_t length = read_form(at, end, to)) return length;
  if (const auto material = longest(words_.materials, at, end)) {
    to.material = material.meaning->name;
    return material.length();
  }
  if (const auto scale = longest(words_.scales, at, end)) {
    to.scale = to.scale.cwiseProduct(*scale.meaning);
    return scale.length();
  }
  if (words_.directions.count((*this)[at])) {
    to.direction = texts_[at];
    return 1;
  }
  for (std::size_t last = std::min({end, at + 2, size()}); last > at; --last)
    if (std::string name = texts_[at] + (last > at + 1 ? texts_[at + 1] : "");
        shape::parse_color(name)) {
      to.color = std::move(name);
      return last - at;
    }
  return 0;
}

bool PhraseText::is_attribute(const NounPhrase& phrase) const {
  const std::size_t last = last_word(phrase);
  Attributes read;
  std::size_t at = content(phrase), length = 0;
  for (; at <= last; at += std::max<std::size_t>(length, 1))
    length = read_attribute(at, last + 1, read);
  if (length == 0) return false;
  // "of oak", but "a ladder".
  const bool is_stuff = phrase.determiner == language::Determiner::absent ||
                        phrase.determiner == language::Determiner::no;
  return is_stuff && phrase.count == 0 && !phrase.is_plural
             ? true
             : !kind(phrase) && !part(phrase, nullptr);
}

std::optional<int> count_of(const NounPhrase& phrase) {
  const bool article =
      phrase.count == 1 && (phrase.determiner == language::Determiner::indefinite ||
                            phrase.determiner == language::Determiner::another);
  if (phrase.count < 1 || phrase.count > most_count || article || phrase.is_vague)
    return std::nullopt;
  return static_cast<int>(phrase.count);
}

bool may_be_part(const std::string& noun) {
  using language::WordClass;
  const auto& english = language::lexicon();
  const auto no_parts = {WordClass::person,   WordClass::activity, WordClass::time,
                         WordClass::feeling,  WordClass::event,    WordClass::attribute,
                         WordClass::quantity, WordClass::place,    WordClass::color,
                         WordClass::animal};
  return english.may_be(noun, WordClass::artefact) || english.is(noun, WordClass::shape) ||
         std::none_of(no_parts.begin(), no_parts.end(),
                      [&](WordClass one) { return english.is(noun, one); });
}

}  // namespace roomgen::create
