#include "phrase_nouns.h"

#include "roomgen/base/text.h"

namespace roomgen::create {

using Role = PhraseNoun::Role;

bool PhraseNouns::is_pronoun(std::size_t at) const {
  return text_.kind(at).length == 1 && words_.fillers.count(text_[at]) &&
         (at == 0 || !text_.is(at - 1, {"a", "an", "the"}));
}

PhraseNoun PhraseNouns::compound(std::size_t at, const Description* head) const {
  const auto kind = text_.kind(at);
  const std::size_t after = at + kind.length;
  // "a piano stool", "a merry-go-round bookshelf": the last is the thing.
  if (kind && text_.kind(after)) return {Role::modifier, kind.length, "", nullptr};
  // "an oven door", "a drawer unit": the thing only says what the part is like, or the part the
  // thing.
  if (kind && head)
    if (const auto part = part_at(after, head); part && !has_relation(after + 1))
      return {Role::part, kind.length + part.length, part.meaning, nullptr};
  // "a cube body", "bottle holders": nouns that say what the next one is like.
  if (is_adjunct(at, kind.length, head)) return {Role::modifier, 1, "", nullptr};
  return {};
}

PhraseNoun PhraseNouns::simple(std::size_t at, const Description* head) const {
  const auto kind = text_.kind(at);
  if (const auto part = part_of_head(at, kind.length, head))
    return {Role::part, part.length, part.meaning, nullptr};
  if (!kind) return {};
  // "a football team": the last word says that it is no football.
  const std::size_t after = at + kind.length;
  if (!head && after < text_.size() && words_.no_objects.count(text_[after])) return {};
  return {Role::object, kind.length, "", kind.meaning};
}

PhraseText::Run<std::string> PhraseNouns::part_of_head(std::size_t at, std::size_t kind_length,
                                                       const Description* head) const {
  auto part = part_at(at, head);
  // "ten test tubes": of the rack of which they are parts.
  if (kind_length > 1)
    if (const auto last = part_at(at + kind_length - 1, head); last && has_part(head, last.meaning))
      return {kind_length, last.meaning};
  // "a back panel" is the back.
  if (part.length == 1 && has_part(head, part.meaning))
    if (const auto next = part_at(at + 1, head); next && !has_part(head, next.meaning))
      part.length += next.length;
  if (kind_length > part.length && part && has_part(head, part.meaning) &&
      !has_relation(at + kind_length))
    return {kind_length, part.meaning};
  // "an open shelf": the longer name of a kind ends with what is a part here.
  if (head && kind_length > part.length)
    if (const auto ending = part_at(at + kind_length - 1, head);
        ending && (has_part(head, ending.meaning) || head->kind.empty()))
      part = {kind_length, ending.meaning};
  if (!part || !is_part(at, kind_length, part, head)) return {};
  return part;
}

bool PhraseNouns::is_adjunct(std::size_t at, std::size_t kind_length,
                             const Description* head) const {
  const std::size_t after = at + 1;
  if (!head || after >= text_.size() || kind_length > 1) return false;
  const auto part = part_at(at, head);
  if (part.length == 1)
    if (const auto next = part_at(after, head))
      return has_part(head, next.meaning) || !has_part(head, part.meaning);
  return kind_length == 1 && !part && is_unknown_noun(after, head);
}

bool PhraseNouns::is_unknown_noun(std::size_t at, const Description* head) const {
  const std::string& word = text_[at];
  return word != "," && !words_.boundaries.count(word) && !words_.fillers.count(word) &&
         !says_nothing(word) && !text_.kind(at) && !part_at(at, head) && !text_.color(at) &&
         !text_.count(at) && singular(word) != word;
}

// The part that the words name: one that the thing has, if they may mean several.
PhraseText::Run<std::string> PhraseNouns::part_at(std::size_t at, const Description* head) const {
  // Recipes have parts of which no list knows.
  const auto known = text_.part(at);
  if (known.length < 2 && at < text_.size() && !says_nothing(text_[at]) &&
      has_part(head, singular(text_[at])))
    return {1, singular(text_[at])};
  for (const auto& label : known.meaning)
    if (has_part(head, label)) return {known.length, label};
  if (known) return {known.length, known.meaning.front()};
  return {};
}

bool PhraseNouns::is_part(std::size_t at, std::size_t kind_length,
                          const PhraseText::Run<std::string>& part,
                          const Description* head) const {
  if (kind_length > part.length) return false;
  if (kind_length == 0) return true;
  // "seat stool": a part before the thing that it is a part of.
  const std::size_t after = at + part.length;
  if (!head) return static_cast<bool>(text_.kind(after));
  return !kinds_.find(head->kind) || has_part(head, part.meaning) || !has_relation(after);
}

bool PhraseNouns::has_part(const Description* head, const std::string& label) const {
  const ShapeKind* kind = head ? kinds_.find(head->kind) : nullptr;
  return kind && kinds_.labels(kind->recipe).count(label) > 0;
}

bool PhraseNouns::has_relation(std::size_t from) const {
  for (const std::size_t at : {from, from + 1})
    if (text_.is(at, {"around", "on", "next", "beside", "under", "underneath", "behind"}))
      return true;
  return from + 2 < text_.size() && text_.starts(from, {"in", "front"});
}

}  // namespace roomgen::create
