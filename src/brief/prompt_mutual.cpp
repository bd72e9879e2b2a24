#include <algorithm>

#include "place_readers.h"

namespace roomgen::brief {

namespace {

// "face to face", "back to back": which way they look counts, and a row is none.
bool turns(const Placement& placement) {
  return std::any_of(placement.relations.begin(), placement.relations.end(), [](RelationKind kind) {
    return kind == RelationKind::face_to || kind == RelationKind::face_opposite_to;
  });
}

bool stand_in_row(PromptReading& reading, std::size_t things, std::size_t heard) {
  Mention& mention = reading.brief.mentions[things];
  if (mention.quantity < 2 || mention.mount != Mount::floor || mention.formation) return false;
  mention.formation = Formation{.rows = 1};
  mention.formation_heard = heard;
  return true;
}

// Half of them are at the others.
void turn_halves(PromptReading& reading, std::size_t things, const Placement& placement) {
  const int number = reading.talk.mention(things).quantity;
  // Of two rows each half is one.
  if (auto& formation = reading.brief.mentions[things].formation; formation && formation->rows == 2) formation->rows = 1, formation->columns = 0;
  const std::size_t second = reading.talk.part(things, number / 2);
  if (second == things) return;
  for (auto kind : placement.relations) reading.talk.add(second, {kind, things, "", false});
  if (placement.relations.front() != RelationKind::behind) return;
  // What has another at its back stands at no wall.
  Demand free{RelationKind::middle, Demand::none, "", false};
  free.is_means = true;
  reading.talk.add(things, free);
}

// "twelve desks in pairs": each of the second half is at one of its own of the first.
void stand_in_pairs(PromptReading& reading, std::size_t things, const Placement& placement) {
  const Mention& mention = reading.talk.mention(things);
  const int number = mention.quantity;
  if (mention.mount != Mount::floor || number < 4 || number % 2 != 0) return;
  const std::size_t second = reading.talk.part(things, number / 2);
  if (second == things) return;
  for (auto kind : placement.relations) reading.talk.add(second, {kind, things, "", false});
  reading.brief.shared_out.push_back({.thing = second, .owner = things, .heard = reading.talk.told()});
}

void relate_each_other(PromptReading& reading, std::size_t things, const Placement& placement) {
  const Mention& mention = reading.talk.mention(things);
  if (placement.paired) return stand_in_pairs(reading, things, placement);
  if (!turns(placement)) {
    if (mention.mount == Mount::floor) stand_in_row(reading, things, reading.talk.told());
    return;
  }
  // On both sides of something they face it.
  for (const auto& demand : mention.demands)
    if (demand.flank && demand.mention != Demand::none)
      return reading.talk.add(things, {RelationKind::face_to, demand.mention, "", false});
  // "chairs facing each other" are two; of six three face the others.
  if (mention.quantity == 0) reading.brief.mentions[things].quantity = 2;
  const int number = reading.talk.mention(things).quantity;
  if (number >= 2 && number % 2 == 0) turn_halves(reading, things, placement);
}

}  // namespace

// The last two of a list; "two sofas facing each other": the second and the first.
void relate_mutually(PromptReading& reading, const Indices& things, const Placement& placement) {
  if (things.size() == 1) relate_each_other(reading, things.front(), placement);
  if (things.size() < 2) return;
  for (auto kind : placement.relations)
    reading.talk.add(things.back(), {kind, things[things.size() - 2], "", false});
}

// "two desks side by side" are a row.
void relate_listed(PromptReading& reading, std::size_t token, const Placement& placement, std::size_t heard) {
  Indices things;
  for (const auto& verb : reading.parse.verbs)
    if (verb.tokens.begin == token && verb.subject != language::none) things = reading.mentions_of_list(verb.subject);
  if (things.size() == 1) return relate_each_other(reading, things.front(), placement);
  if (things.size() > 1) return relate_mutually(reading, things, placement);
  things = reading.named_before(token);
  if (turns(placement)) {
    if (!things.empty() && reading.talk.mention(things.back()).quantity != 1)
      return relate_each_other(reading, things.back(), placement);
  } else if (!things.empty() && stand_in_row(reading, things.back(), heard)) {
    return;
  }
  relate_mutually(reading, things, placement);
}

}  // namespace roomgen::brief
