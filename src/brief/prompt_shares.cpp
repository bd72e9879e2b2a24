#include "prompt_shares.h"

#include <algorithm>

namespace roomgen::brief {

using language::Attachment;
using language::Determiner;
using language::none;
using language::NounPhrase;

void ShareReader::give_each(std::size_t owner, const Indices& things, std::uint32_t at) {
  for (const std::size_t thing : things)
    if (thing != owner && reading_.talk.mention(thing).part_of != owner && given_.insert(thing).second) {
      share({.thing = thing, .owner = owner, .count = std::max(1, reading_.talk.mention(thing).quantity)}, at);
      reading_.talk.multiply(thing, number_of(owner));
      give_what_carries(owner, thing, at);
    }
}

std::optional<int> ShareReader::number_of_some(std::size_t owner, const NounPhrase& said, bool between) const {
  if (said.determiner != Determiner::each) return std::nullopt;
  const int number = number_of(owner);
  int every = said.count == 2.0 ? 2 : 0;
  for (auto i = said.tokens.begin; i < said.head; ++i)
    every = reading_.is_word(i, "other") || reading_.is_word(i, "second") ? 2 : reading_.is_word(i, "third") ? 3 : every;
  if (every == 0 || number < 2) return std::nullopt;
  if (said.count == 2.0) return between ? number - 1 : number / 2;
  return (number + every - 1) / every;
}

void ShareReader::give_some(int number, const Indices& things, const NounPhrase& owner) {
  for (const std::size_t thing : things) {
    if (!given_.insert(thing).second) continue;
    reading_.talk.set_count(thing, std::max(1, reading_.talk.mention(thing).quantity) * number);
    reading_.hearing.number(language::Run{owner.tokens.begin, owner.head}, thing);
  }
}

void ShareReader::give_each_place(const PlacePhrase& place, const Indices& things, std::uint32_t at) {
  constexpr int corners = 4;
  const bool is_corner = place.place == Place::corner, is_window = place.place == Place::window;
  if (!is_corner && !is_window && place.place != Place::door) return;
  const int number = is_corner ? corners : is_window ? std::max(2, reading_.brief.windows.value_or(0)) : doors_said();
  for (const std::size_t thing : things)
    if (const Mention& one = reading_.talk.mention(thing); (one.quantity == 1 || !one.counted) && given_.insert(thing).second) {
      share({.thing = thing, .place = is_corner ? "corner" : is_window ? "window" : "door"}, at);
      have_for_each(thing, number);
    }
}

void ShareReader::have_for_each(std::size_t thing, int number) {
  if (reading_.talk.mention(thing).quantity == 0) reading_.talk.expect(thing, 1);
  reading_.talk.multiply(thing, number);
}

bool ShareReader::give_what_each_place_has(const Attachment& attachment) {
  const NounPhrase& owner = reading_.phrase(attachment.from);
  const auto place = reading_.place_named(owner);
  if (owner.determiner != Determiner::each || !place) return false;
  const bool is_opening = place->place == Place::window || place->place == Place::door;
  if (!is_opening && place->place != Place::corner) return false;
  const Indices things = reading_.all_of(attachment.to);
  if (!reading_.is_told_at_pronoun(attachment.to)) {
    Placement near;
    near.relations = {is_opening ? RelationKind::near : RelationKind::on};
    reading_.talk.locate(things, near, *place);
  }
  give_each_place(*place, things, attachment.tokens.begin);
  for (const std::size_t thing : things) place_of_.insert_or_assign(thing, *place);
  return true;
}

const PlacePhrase* ShareReader::place_having(std::size_t thing) const {
  const auto found = place_of_.find(thing);
  return found == place_of_.end() ? nullptr : &found->second;
}

int ShareReader::doors_said() const {
  int number = 0;
  for (const OpeningWish& wish : reading_.brief.openings)
    if (wish.kind.find("door") != std::string::npos) number += wish.count;
  return std::max(1, number);
}

void ShareReader::give_each_side(const Attachment& attachment, const Indices& things) {
  const NounPhrase& side = reading_.phrase(attachment.to), &from = reading_.phrase(attachment.from);
  const bool is_each = side.determiner == Determiner::each;
  if (!(is_each || side.determiner == Determiner::any) || side.is_plural || from.is_pronoun) return;
  for (const std::size_t thing : things) {
    const Mention& mention = reading_.talk.mention(thing);
    const bool is_seat = reading_.text.table.is_any_of(mention.category, {"chair", "stool"});
    const int fewest = is_each && is_seat ? 2 : 3;
    if (mention.counted && mention.quantity >= fewest && mention.part_of == Demand::none && !has_parts(thing) &&
        given_.insert(thing).second)
      reading_.talk.multiply(thing, 2);
  }
}

void ShareReader::read_for_each(const Attachment& attachment) {
  if (is_for_each_person(attachment)) return give_each_person(attachment);
  if (!is_for_each(attachment)) return;
  const std::size_t owner = *reading_.mention_of(attachment.to);
  const Indices things = reading_.subjects_of(attachment);
  reading_.talk.told_by(reading_.hearing.relation(attachment, none));
  if (const auto some = number_of_some(owner, reading_.phrase(attachment.to), false))
    give_some(*some, things, reading_.phrase(attachment.to));
  else
    give_each(owner, things, attachment.tokens.begin);
  for (const std::size_t thing : things) {
    if (thing == owner) continue;
    reading_.talk.own(owner, thing, true);
    if (!is_tied(thing, owner)) reading_.talk.add(thing, {RelationKind::near, owner, "", false});
  }
}

// "for two painters, with an easel for each"
bool ShareReader::is_for_each_person(const Attachment& attachment) const {
  if (!says_for_each(attachment)) return false;
  const NounPhrase& whom = reading_.phrase(attachment.to);
  return reading_.brief.people > 1 && !reading_.mention_of(attachment.to) && (whom.is_pronoun || reading_.is_somebody(whom));
}

void ShareReader::give_each_person(const Attachment& attachment) {
  reading_.talk.told_by(reading_.hearing.relation(attachment, none));
  const NounPhrase& whom = reading_.phrase(attachment.to);
  Indices things = reading_.subjects_of(attachment);
  if (const auto joined = reading_.joined_before(attachment.from); joined && !is_among(things, *joined)) things.push_back(*joined);
  for (const std::size_t thing : things) {
    if (!given_.insert(thing).second) continue;
    have_for_each(thing, reading_.brief.people);
    reading_.hearing.number(language::Run{whom.tokens.begin, whom.head + 1}, thing);
  }
}

bool ShareReader::is_for_each(const Attachment& attachment) const {
  return reading_.mention_of(attachment.to) && says_for_each(attachment);
}

bool ShareReader::says_for_each(const Attachment& attachment) const {
  if (attachment.relation == "per") return true;
  if (attachment.relation != "for" || attachment.to == none) return false;
  const NounPhrase& whom = reading_.phrase(attachment.to);
  return whom.determiner == Determiner::each || reading_.is_word(whom.head, "everyone") || reading_.is_word(whom.head, "everybody");
}

bool ShareReader::is_tied(std::size_t thing, std::size_t owner) const {
  const auto& demands = reading_.talk.mention(thing).demands;
  return std::any_of(demands.begin(), demands.end(), [&](const Demand& demand) { return demand.mention == owner; });
}

int ShareReader::number_of(std::size_t owner) const {
  int number = 0;
  for (const std::size_t one : reading_.talk.with_parts(owner)) number += reading_.talk.mention(one).quantity;
  return number;
}

void ShareReader::share(SharedOut shared, std::uint32_t at) {
  shared.heard = reading_.talk.told();
  if (const auto each = each_around(at)) shared.word = hear(reading_.brief, {*each, *each + 1}, Heard::As::count);
  reading_.brief.shared_out.push_back(std::move(shared));
}

// "each", "every", "per" nearest to what is being read.
std::optional<std::uint32_t> ShareReader::each_around(std::uint32_t token) const {
  constexpr std::uint32_t farthest = 8;
  const auto is_each = [&](std::uint32_t i) {
    return reading_.is_word(i, "each") || reading_.is_word(i, "every") || reading_.is_word(i, "per");
  };
  for (std::uint32_t n = 0; n <= farthest; ++n) {
    if (n <= token && is_each(token - n)) return token - n;
    if (is_each(token + n)) return token + n;
  }
  return std::nullopt;
}

// "each desk has a lamp on a shelf": as many shelves.
void ShareReader::give_what_carries(std::size_t owner, std::size_t thing, std::uint32_t at) {
  for (const Attachment& attachment : reading_.parse.attachments) {
    const auto& said = reading_.placement(attachment);
    if (attachment.from == none || reading_.mention_of(attachment.from) != thing || !said || said->target == none ||
        said->placement->relations.front() != RelationKind::on ||
        reading_.phrase(said->target).determiner != Determiner::indefinite)
      continue;
    const auto carrier = reading_.mention_of(said->target);
    if (carrier && *carrier != owner && reading_.talk.mention(*carrier).quantity == 1) give_each(owner, {*carrier}, at);
  }
}

}  // namespace roomgen::brief
