#include "placement.h"

#include "placement_phrase.h"

namespace roomgen::brief {

namespace {

using language::Attachment;
using language::NounPhrase;
using language::Run;

std::string text_of(const PromptText& text, const Run& run) {
  std::string result;
  for (auto i = run.begin; i < run.end; ++i)
    result += (result.empty() ? "" : " ") + text.plain[i].text;
  return result;
}

const Placement* find(const PromptText& text, const std::string& phrase) {
  const auto found = text.words.placements.find(phrase);
  return found == text.words.placements.end() ? nullptr : &found->second;
}

const NounPhrase& phrase_at(const PromptText& text, std::int32_t phrase) {
  return text.parse.phrases[static_cast<std::size_t>(phrase)];
}

// What "of" joins to a noun phrase.
std::int32_t owner_of(const PromptText& text, std::int32_t phrase) {
  for (const auto& attachment : text.parse.attachments)
    if (attachment.from == phrase && attachment.relation == "of") return attachment.to;
  return language::none;
}

// The verb that a preposition belongs to, as written: "surrounded", "leaning".
std::string verb_of(const PromptText& text, const Attachment& attachment) {
  if (attachment.verb == language::none) return "";
  const auto& verb = text.parse.verbs[static_cast<std::size_t>(attachment.verb)];
  return text.plain[verb.tokens.end - 1].text;
}

// "the corner of the room", "of a tea house" is a place, not the corner of something.
bool is_place(const PromptText& text, const NounPhrase& part, std::int32_t owner) {
  const auto place = read_place(text.plain, part.tokens.begin, text.words);
  if (!place || owner == language::none) return false;
  const std::uint32_t head = phrase_at(text, owner).head;
  return text.plain[head].kind == Token::Kind::room || part.tokens.begin + place->length > head;
}

// "on each side of the bed": the part is said as if it were the target.
std::optional<SaidPlacement> by_part(const PromptText& text, const Attachment& attachment,
                                     const std::string& relation, const std::string& verb) {
  const NounPhrase& part = phrase_at(text, attachment.to);
  const std::string words = relation + " " + text_of(text, part.tokens);
  const std::int32_t owner = owner_of(text, attachment.to);
  if (is_place(text, part, owner)) return std::nullopt;
  for (const std::string& phrase : {verb + " " + words, words}) {
    if (owner != language::none)
      if (const auto* found = find(text, phrase + " of")) return SaidPlacement{found, owner, false};
    if (const auto* found = find(text, phrase)) return SaidPlacement{found, language::none, false};
  }
  return std::nullopt;
}

// "its back to the window"
const Placement* by_own_part(const PromptText& text, const Attachment& attachment, const std::string& relation) {
  if (attachment.is_verb || attachment.from == language::none) return nullptr;
  const std::uint32_t head = phrase_at(text, attachment.from).head;
  const bool is_part = text.words.portions.count(text.plain[head].text) > 0;
  return is_part && head + 1 == attachment.tokens.begin ? find(text, text.plain[head].text + " " + relation) : nullptr;
}

const Placement* by_words(const PromptText& text, const Attachment& attachment,
                          const std::string& relation, const std::string& verb) {
  for (const std::string& phrase : {verb + " " + relation, relation})
    if (const auto* found = find(text, phrase)) return found;
  return attachment.is_verb ? find(text, attachment.relation) : nullptr;
}

}  // namespace

std::optional<SaidPlacement> placement_of(const PromptText& text, const Attachment& attachment) {
  const bool is_elided = attachment.tokens.size() == 0;  // "a lamp either side of the bed"
  const std::string relation = attachment.is_verb ? text.plain[attachment.tokens.end - 1].text
                               : is_elided        ? attachment.relation
                                                  : text_of(text, attachment.tokens);
  const std::string verb = attachment.is_verb ? "" : verb_of(text, attachment);
  if (attachment.to == language::none) return std::nullopt;
  if (const auto found = by_part(text, attachment, relation, verb)) return found;
  const Placement* placement = by_own_part(text, attachment, relation);
  if (!placement) placement = by_words(text, attachment, relation, verb);
  if (!placement) return std::nullopt;
  SaidPlacement said{placement, attachment.to, false};
  // "the edge of the bathtub" is the bathtub's.
  const NounPhrase& target = phrase_at(text, attachment.to);
  const std::int32_t owner = owner_of(text, attachment.to);
  if (owner != language::none && !is_place(text, target, owner) &&
      text.words.portions.count(text.plain[target.head].text)) {
    said.target = owner;
    said.is_portion = true;
  }
  return said;
}

}  // namespace roomgen::brief
