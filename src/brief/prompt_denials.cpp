#include <algorithm>

#include "place_readers.h"

namespace roomgen::brief {

namespace {

using language::Attachment;
using language::none;
using language::NounPhrase;

// "nothing in front of them"
bool is_nothing(const NounPhrase& phrase) { return phrase.is_pronoun && phrase.is_denied; }

Indices denied_things(const PromptReading& reading, const Attachment& attachment) {
  if (!is_nothing(reading.phrase(attachment.from))) return reading.subjects_of(attachment);
  if (!reading.is_word(reading.phrase(attachment.from).head, "none")) return {};  // "nothing in front of it"
  for (const Attachment& one : reading.parse.attachments)
    if (one.from == attachment.from && one.relation == "of" && one.to != none)
      if (Indices all = reading.all_of(one.to); !all.empty()) return all;
  return reading.all_of(attachment.from);
}

// "not", "never", "none of them": the first token of what denies.
std::uint32_t negation_before(const PromptReading& reading, const Attachment& attachment) {
  constexpr std::uint32_t farthest = 4;
  const NounPhrase& from = reading.phrase(attachment.from);
  if (is_nothing(from)) return from.tokens.begin;
  const auto first = attachment.tokens.begin;
  for (std::uint32_t n = 1; n <= std::min(farthest, first); ++n)
    if (reading.words.negations.count(reading.word(first - n))) return first - n;
  return first;
}

// The part of the room that a phrase names, as the ledger checks it.
std::string part_denied(const PromptReading& reading, std::int32_t target) {
  const auto place = reading.place_named(reading.phrase(target));
  if (!place) return "";
  if (place->place == Place::window) return "window-0";
  if (place->place == Place::door) return "door-0";
  return place->place == Place::wall && !place->centered ? wall_named(*place) : "";
}

}  // namespace

void keep_away(const Denial& denial, Discourse& talk) {
  if (denial.kind != RelationKind::near && denial.kind != RelationKind::next_to && denial.kind != RelationKind::side_of)
    return;
  Demand away{RelationKind::far, denial.target, denial.part, false};
  away.is_means = true;
  talk.add(denial.thing, away);
}

bool denies_place(const PromptReading& reading, const Attachment& attachment) {
  return attachment.is_denied || is_nothing(reading.phrase(attachment.from));
}

void read_denied_place(PromptReading& reading, const Attachment& attachment) {
  const auto said = reading.placement(attachment);
  if (!said || said->placement->inverse || said->placement->flank || said->target == none) return;
  const Indices things = denied_things(reading, attachment);
  const std::string part = part_denied(reading, said->target);
  const auto target = reading.mention_of(said->target);
  if (things.empty() || (!target && part.empty())) return;
  const std::size_t heard = reading.hearing.relation(attachment, target ? none : said->target);
  auto& words = reading.brief.heard[heard].tokens;
  words.begin = std::min(words.begin, negation_before(reading, attachment));
  for (const std::size_t thing : things) {
    if (thing == target) continue;
    reading.brief.denials.push_back({thing, said->placement->relations.front(), target.value_or(no_mention), part, heard});
    keep_away(reading.brief.denials.back(), reading.talk);
  }
}

}  // namespace roomgen::brief
