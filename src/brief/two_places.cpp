#include <algorithm>

#include "place_readers.h"

namespace roomgen::brief {

using language::Attachment;
using language::Determiner;
using language::NounPhrase;

std::optional<Discourse::Both> two_places(const PromptReading& reading, const Attachment& attachment, const SaidPlacement& said) {
  static const WordSet twos = {"both", "two", "opposite", "opposing", "each", "either"}, ends = {"end", "ends", "sides"};
  const NounPhrase& target = reading.phrase(said.target);
  if (reading.is_room(target) && said.placement->flank) return Discourse::Both::ends;
  bool are_two = false, are_sides = false;
  for (auto i = std::min(target.tokens.begin, attachment.tokens.begin); i < target.head; ++i) {
    are_two = are_two || twos.count(reading.word(i));
    are_sides = are_sides || reading.is_word(i, "side");
  }
  if (are_two && ends.count(reading.word(target.head)) && is_of_room(reading, said.target)) return Discourse::Both::ends;
  if (said.placement->relations.front() == RelationKind::face_to) return std::nullopt;
  const auto place = reading.place_named(target);
  if (!place || place->place != Place::wall) return std::nullopt;
  const bool is_either = target.determiner == Determiner::each || reading.is_word(target.tokens.begin, "either");
  if (!(target.is_plural || is_either) || (!are_two && !are_sides && place->length_of_wall.empty())) return std::nullopt;
  if (place->length_of_wall == "short") return Discourse::Both::short_walls;
  return are_sides ? Discourse::Both::side_walls : Discourse::Both::long_walls;
}

std::optional<language::Run> left_and_right(const PromptReading& reading, const Attachment& attachment) {
  const NounPhrase& first = reading.phrase(attachment.to);
  const auto is_side = [&](std::uint32_t token) { return reading.is_word(token, "left") || reading.is_word(token, "right"); };
  if (!is_side(first.head) || !reading.is_word(first.head + 1, "and") || !is_side(first.head + 2)) return std::nullopt;
  const bool is_of_thing = std::any_of(reading.parse.attachments.begin(), reading.parse.attachments.end(), [&](const Attachment& of) {
    return (of.from == attachment.to || of.from == attachment.to + 1) && of.relation == "of" && !reading.is_room(reading.phrase(of.to));
  });
  if (is_of_thing) return std::nullopt;
  static const WordSet named = {"wall", "walls", "side", "sides"};
  const auto last = first.head + 2;
  return language::Run{attachment.tokens.begin, last + (last + 1 < reading.text.plain.size() && named.count(reading.word(last + 1)) ? 2u : 1u)};
}

bool is_of_room(const PromptReading& reading, std::int32_t part) {
  return std::any_of(reading.parse.attachments.begin(), reading.parse.attachments.end(), [&](const Attachment& of) {
    return of.from == part && of.relation == "of" && reading.is_room(reading.phrase(of.to));
  });
}

}  // namespace roomgen::brief
