#include <algorithm>
#include <optional>

#include "place_adverbs.h"
#include "place_readers.h"
#include "place_teller.h"
#include "prompt_owned.h"
#include "prompt_passes.h"
#include "prompt_shares.h"

namespace roomgen::brief {

namespace {

using language::Attachment;
using language::Determiner;
using language::none;
using language::NounPhrase;
using language::Run;

class PlaceReader {
 public:
  explicit PlaceReader(PromptReading& reading)
      : reading_(reading), shares_(reading), owned_(reading, shares_), teller_(reading, owned_), adverbs_(reading, teller_) {}

  void run() {
    for (const auto& attachment : reading_.parse.attachments) {
      adverbs_.read_up_to(attachment.tokens.begin);
      reading_.look_back_from(attachment.tokens.begin);
      teller_.come_to(attachment.tokens.begin);
      read_attachment(attachment);
    }
    adverbs_.read_up_to(reading_.text.plain.size());
    owned_.read_those_behind_each();
    note_lost_sides();
  }

 private:
  // "On the left", of which nothing came.
  void note_lost_sides() {
    const std::vector<bool> heard = reading_.heard_tokens();
    for (const auto& phrase : reading_.parse.phrases) {
      const bool is_side = reading_.is_word(phrase.head, "left") || reading_.is_word(phrase.head, "right");
      if (is_side && !heard[phrase.head])
        hear(reading_.brief, {phrase.head, phrase.head + 1}, Heard::As::not_understood);
    }
  }
  // The noun phrase of a place that is no thing: "the corner", "the foot" of the bed.
  std::int32_t place_of(const Attachment& attachment,
                        const std::optional<SaidPlacement>& said) const {
    if (!said) return none;
    const bool is_part = attachment.to != said->target && !reading_.mention_of(attachment.to);
    if (is_part) return attachment.to;
    return reading_.mention_of(said->target) ? none : said->target;
  }
  void read_attachment(const Attachment& attachment) {
    if (attachment.from == none) return;
    if (denies_place(reading_, attachment)) return read_denied_place(reading_, attachment);
    const auto said = reading_.placement(attachment);
    reading_.talk.told_by(said || reading_.owns(attachment)
                              ? reading_.hearing.relation(attachment, place_of(attachment, said))
                              : HeardWords::none);
    if (!said) {
      if (reading_.owns(attachment) && !shares_.give_what_each_place_has(attachment)) owned_.read(attachment);
      shares_.read_for_each(attachment);
      return;
    }
    if (said->placement->inverse) return read_inverse(attachment, *said);
    const Indices subjects = whom_place_means(attachment, *said);
    if (subjects.empty()) return;
    if (const auto sides = left_and_right(reading_, attachment)) return stand_left_and_right(subjects, *sides);
    if (said->placement->mutual) return relate_mutually(reading_, subjects, *said->placement);
    if (said->placement->flank && is_of_room(reading_, attachment.to)) return reading_.talk.locate_at_both(subjects, Discourse::Both::ends);
    if (said->placement->flank) shares_.give_each_side(attachment, reading_.all_of(attachment.from));
    if (said->target == none) {
      if (said->placement->flank && stand_owners_beside(subjects, attachment, *said->placement)) return;
      // "a throne, six columns down each side": where no table has them at its sides, the room has.
      if (said->placement->flank && said->placement->relations.front() == RelationKind::around && !are_at_table(*said->placement, subjects))
        return reading_.talk.locate_at_both(subjects, Discourse::Both::side_walls);
      return teller_.say_of_implied(subjects, *said->placement);
    }
    read_target(attachment, *said, subjects);
  }
  // "shelves on the left and right" are at those walls, lamps of a bed at its sides.
  void stand_left_and_right(const Indices& subjects, const Run& words) {
    reading_.talk.told_by(hear(reading_.brief, words, Heard::As::relation));
    const auto both = reading_.words.placements.find("on both sides");
    const bool hang = reading_.talk.mention(subjects.front()).mount == Mount::wall;
    const bool are_of_room = hang || reading_.is_word(words.end - 1, "walls") || !owned_.owner_of(subjects.front());
    if (are_of_room || both == reading_.words.placements.end()) return reading_.talk.locate_at_both(subjects, Discourse::Both::side_walls);
    teller_.say_of_implied(subjects, both->second);
  }
  bool are_at_table(const Placement& placement, const Indices& subjects) const {
    const auto what = teller_.implied(placement.relations.front(), subjects);
    return what && reading_.text.table.is_any_of(reading_.talk.mention(*what).category, {"table", "kitchen island"});
  }
  // "a bar with seven stools along the back wall": where seats and what they are at are told of, the place is said of what
  // they are at.
  Indices whom_place_means(const Attachment& attachment, const SaidPlacement& said) {
    const Indices subjects = with_joined_before(attachment, reading_.subjects_of(attachment));
    if (subjects.size() != 1 || said.target == none) return subjects;
    if (const auto target = reading_.mention_of(said.target)) {
      const auto carrier = owned_.owner_of(subjects.front());
      if (!carrier || carrier == target || !is_said_of_carrier(attachment, said, *carrier)) return subjects;
      owned_.hang_over(*carrier, subjects.front());
      return {*carrier};
    }
    const auto owner = owned_.owner_of(subjects.front());
    const auto place = reading_.place_named(reading_.phrase(said.target));
    const bool is_seat = reading_.text.table.is_any_of(reading_.talk.mention(subjects.front()).category, {"chair", "stool"});
    // "a barrel with two glasses on top in the middle"
    const bool is_told_on_it = owner && place && place->place != Place::wall && place->place != Place::ceiling &&
                               (teller_.stands_on(subjects.front(), *owner) || reading_.talk.is_small(subjects.front()));
    if (!place || !owner || !(is_seat || is_told_on_it) || place->place == Place::floor) return subjects;
    return {*owner};
  }
  // "a watering can by the door, an iron chair and small table at the far end": without an article of its own the last is
  // one with what it is joined to.
  Indices with_joined_before(const Attachment& attachment, Indices subjects) const {
    const NounPhrase& said = reading_.phrase(attachment.from);
    const bool is_bare = said.determiner == Determiner::absent && said.count == 0 && !said.is_plural && !said.is_pronoun;
    const auto other = is_bare && reading_.mention_of(attachment.from) ? reading_.joined_before(attachment.from) : std::nullopt;
    if (other && !is_among(subjects, *other)) subjects.insert(subjects.begin(), *other);
    return subjects;
  }
  // "a cake with six candles on the table", "a board with tools over the bench": of what small things are with, where
  // something known is named ("a board with tools on a rail": the tools are on that).
  bool is_said_of_carrier(const Attachment& attachment, const SaidPlacement& said, std::size_t carrier) const {
    const NounPhrase& target = reading_.phrase(said.target);
    const bool is_with = std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(), [&](const Attachment& with) {
      return with.to == attachment.from && reading_.owns(with) && reading_.mention_of(with.from) == carrier && !with.is_verb;
    });
    const bool is_behind = reading_.phrase(attachment.from).head + 1 == attachment.tokens.begin;
    const auto had = reading_.mention_of(attachment.from);
    if (!had) return false;
    // "a vanity with a mirror across from the bed"
    const RelationKind relation = said.placement->relations.front();
    const bool hangs_on_it = reading_.talk.mention(*had).mount == Mount::wall && relation != RelationKind::above && relation != RelationKind::on;
    return is_with && is_behind && !target.is_pronoun && target.determiner == Determiner::definite && !said.placement->flank &&
           (reading_.talk.is_small(*had) || hangs_on_it);
  }
  // "a bed, a nightstand with a lamp on each side": the nightstands are at the sides of the bed, each with its lamp.
  bool stand_owners_beside(const Indices& subjects, const Attachment& attachment, const Placement& placement) {
    const bool may_stand_on_it = subjects.size() == 1 && (reading_.talk.is_small(subjects.front()) ||
                                                         reading_.text.table.is_a(reading_.talk.mention(subjects.front()).category, "lamp"));
    if (!may_stand_on_it) return false;
    const auto owner = owned_.owner_of(subjects.front());
    if (!owner || reading_.talk.mention(*owner).mount != Mount::floor) return false;
    const std::size_t carrier = *owner;
    const auto target = teller_.implied(placement.relations.front(), {carrier, subjects.front()});
    if (!target) return false;
    teller_.say({carrier}, {&placement, none, false}, *target);
    shares_.give_each(carrier, subjects, attachment.tokens.begin);
    return true;
  }
  // "left", "right end": the side that a phrase names, as the placement "left of" has it.
  const Placement* side_named(const NounPhrase& phrase) const {
    for (std::uint32_t i = phrase.tokens.begin; i <= phrase.head; ++i) {
      const bool is_side = i == phrase.head || (reading_.words.portions.count(reading_.word(phrase.head)) > 0 &&
                                                !reading_.is_word(phrase.head, "corner") && !reading_.is_word(phrase.head, "edge"));
      const auto found = reading_.words.placements.find(reading_.word(i) + " of");
      if (is_side && found != reading_.words.placements.end() && is_beside(found->second)) return &found->second;
    }
    return nullptr;
  }
  // "the crib's left", "its right end": beside what owns the side.
  bool stand_beside_owner(const NounPhrase& phrase, const Indices& subjects) {
    const Placement* side = side_named(phrase);
    if (!side) return false;
    if (phrase.determiner == Determiner::possessive) return teller_.say_of_implied(subjects, *side), true;
    const auto owner = owner_named(phrase);
    if (!owner || is_among(subjects, *owner)) return false;
    teller_.say(subjects, {side, none, false}, *owner);
    return true;
  }
  // "the crib's": the thing spoken of before that the words mean.
  std::optional<std::size_t> owner_named(const NounPhrase& phrase) const {
    for (auto i = phrase.modifiers.begin; i < phrase.modifiers.end; ++i) {
      const auto& modifier = reading_.parse.modifiers[i];
      if (modifier.kind == language::Modifier::Kind::owner)
        return reading_.talk.last_of(mention_at(reading_.text.table, reading_.text.plain, modifier.tokens.begin));
    }
    return std::nullopt;
  }
  void read_target(const Attachment& attachment, const SaidPlacement& said, const Indices& told) {
    const bool is_of_each = said.target != none && reading_.phrase(said.target).determiner == Determiner::each;
    const Indices subjects = is_of_each && reading_.mention_of(said.target) ? with_those_before(attachment, told) : told;
    if (stand_beside_owner(reading_.phrase(attachment.to), subjects)) return;
    if (const auto* place = shares_.place_having(subjects.front()); place && reading_.phrase(said.target).is_pronoun)
      return reading_.talk.locate(subjects, *said.placement, *place);
    const NounPhrase& target = reading_.phrase(said.target);
    const auto thing = reading_.mention_of(said.target);
    if (thing && !(is_among(subjects, *thing) && reading_.place_named(target))) {
      if (const auto some = shares_.number_of_some(*thing, target, said.placement->relations.front() == RelationKind::between))
        shares_.give_some(*some, subjects, target);
      else if (target.determiner == Determiner::each &&
          said.placement->relations.front() != RelationKind::aligned)
        shares_.give_each(*thing, subjects, attachment.tokens.begin);
      if (is_all(target) && !reading_.talk.mention(subjects.front()).counted)
        shares_.give_each(*thing, subjects, attachment.tokens.begin);
      if (is_own(target) && reading_.talk.mention(*thing).quantity == 1)
        shares_.give_each(subjects.front(), {*thing}, attachment.tokens.begin);
      teller_.say(subjects, said, *thing);
      for (const std::size_t further : reading_.also[static_cast<std::size_t>(said.target)])
        if (reaches_all(said.placement->relations.front()) && !is_among(subjects, further)) teller_.say(subjects, said, further);
      return;
    }
    if (said.placement->relations.front() == RelationKind::face_to && reading_.is_somebody(target))
      if (const auto seats = seats_of_several()) return teller_.say(subjects, said, *seats);
    if (is_way_in(target, *said.placement))
      return reading_.talk.locate(subjects, *said.placement, PlacePhrase{.place = Place::door});
    if (const auto both = two_places(reading_, attachment, said)) return locate_at_both(subjects, *both, target.determiner == Determiner::each && !reading_.means_some(attachment.from));
    if (reading_.is_room(target)) {
      if (said.placement->centered) reading_.talk.locate(subjects, *said.placement, PlacePhrase{});
      return;
    }
    auto place = reading_.place_named(target);
    if (!place) return;
    if (place->place == Place::region && place->side >= 0 && is_along(attachment)) place->place = Place::wall, place->wall = place->side;
    // "three beds, each in its own corner": what stands on the floor has a corner of the room.
    const bool has_own = reading_.talk.mention(subjects.front()).mount == Mount::floor && !owned_.owner_of(subjects.front());
    if (target.determiner == Determiner::possessive && is_portion(*place) && !has_own)
      return lie_on_owner(subjects);
    if (target.determiner == Determiner::each || is_all(target)) shares_.give_each_place(*place, subjects, attachment.tokens.begin);
    if (place->place == Place::middle)
      return locate_in_middle(attachment, subjects, *said.placement, *place);
    reading_.talk.locate(subjects, *said.placement, *place);
  }
  // "four shelves along each long wall" are eight; of six "three along each" are all.
  void locate_at_both(const Indices& subjects, Discourse::Both both, bool at_each) {
    for (const std::size_t subject : subjects)
      if (at_each && reading_.talk.mention(subject).counted && reading_.talk.mention(subject).quantity > 1) reading_.talk.multiply(subject, 2);
    reading_.talk.locate_at_both(subjects, both);
  }
  // "a monitor and keyboard on each", "a stool and a trolley next to each": the small things of the list that were named
  // before, and what is joined to the last.
  Indices with_those_before(const Attachment& attachment, Indices subjects) const {
    const auto joined = reading_.joined_before(attachment.from);
    if (joined && !owned_.is_told_somewhere(attachment.from - 1) && !is_among(subjects, *joined)) subjects.push_back(*joined);
    for (const auto id : reading_.parse.with_list(static_cast<std::uint32_t>(attachment.from))) {
      const auto mention = reading_.mention_of(static_cast<std::int32_t>(id));
      const bool is_meant = mention && static_cast<std::int32_t>(id) < attachment.from && reading_.talk.is_small(*mention) &&
                            !owned_.is_told_somewhere(static_cast<std::int32_t>(id));
      if (is_meant && reading_.talk.mention(*mention).demands.empty() && !is_among(subjects, *mention)) subjects.push_back(*mention);
    }
    return subjects;
  }
  // "ten dryers along the left": at that wall
  bool is_along(const Attachment& attachment) const {
    static const WordSet alongs = {"along", "against", "down"};
    return alongs.count(attachment.relation) > 0;
  }
  // "flowers on all tables"
  bool is_all(const NounPhrase& target) const { return target.is_plural && reading_.is_word(target.tokens.begin, "all"); }
  // "three chairs, each facing its own mirror"
  bool is_own(const NounPhrase& target) const {
    return target.head > 0 && target.determiner == Determiner::possessive && reading_.is_word(target.tokens.begin + 1, "own");
  }
  // "a rug under them", but next to one of them.
  static bool reaches_all(RelationKind kind) {
    return kind == RelationKind::between || kind == RelationKind::under || kind == RelationKind::above ||
           kind == RelationKind::face_to || kind == RelationKind::in_front_of;
  }
  // "facing the pupils" is facing where they sit.
  std::optional<std::size_t> seats_of_several() const {
    std::optional<std::size_t> most;
    for (std::size_t i = 0; i < reading_.talk.count(); ++i) {
      const Mention& mention = reading_.talk.mention(i);
      const bool is_seat = mention.quantity > 1 && reading_.text.table.is_any_of(mention.category, {"seat"});
      if (is_seat && (!most || mention.quantity > reading_.talk.mention(*most).quantity)) most = i;
    }
    return most;
  }
  // "facing the entrance" means the door, "in the entrance" the room.
  bool is_way_in(const NounPhrase& target, const Placement& placement) const {
    const auto part = reading_.words.room_parts.find(reading_.word(target.head));
    return part != reading_.words.room_parts.end() && part->second == "door" &&
           target.determiner == Determiner::definite &&
           placement.relations.front() != RelationKind::on;
  }
  static bool is_portion(const PlacePhrase& place) {
    return place.place == Place::corner || place.place == Place::middle ||
           place.place == Place::region;
  }
  // "every mat has a block at its left corner", "at its center"
  void lie_on_owner(const Indices& subjects) {
    if (const auto owner = owned_.owner_of(subjects.front()))
      return reading_.talk.demand(subjects, {RelationKind::on, *owner, "", false});
    if (const auto thing = reading_.talk.antecedent(subjects))
      reading_.talk.demand(subjects, {RelationKind::on, *thing, "", false});
  }
  // "the middle of the table" is on the table.
  void locate_in_middle(const Attachment& attachment, const Indices& subjects,
                        const Placement& placement, const PlacePhrase& place) {
    if (const auto owner = owner_named(reading_.phrase(attachment.to)))
      return reading_.talk.demand(subjects, {RelationKind::on, *owner, "", false});
    for (const Attachment& of : reading_.parse.attachments) {
      if (of.from != attachment.to || of.relation != "of") continue;
      if (const auto thing = reading_.mention_of(of.to)) {
        if (reading_.phrase(of.to).determiner == Determiner::each) shares_.give_each(*thing, subjects, attachment.tokens.begin);
        return reading_.talk.demand(subjects, {RelationKind::on, *thing, "", false});
      }
      auto wall = reading_.place_named(reading_.phrase(of.to));
      const bool is_of_opening = wall && (wall->place == Place::window || wall->place == Place::door);  // "of the window wall"
      if (wall && (wall->place == Place::wall || is_of_opening)) {
        wall->centered = true;
        reading_.talk.told_by(hear(reading_.brief, {attachment.tokens.begin, reading_.phrase(of.to).head + 1}, Heard::As::relation));
        Placement against;
        against.relations = {RelationKind::near};
        return reading_.talk.locate(subjects, against, *wall);
      }
    }
    // "three candlesticks down the middle": of the table.
    const auto carrier = is_along(attachment) ? teller_.implied(RelationKind::on, subjects) : std::nullopt;
    if (carrier && std::all_of(subjects.begin(), subjects.end(), [&](std::size_t i) { return reading_.talk.is_small(i); }))
      return reading_.talk.demand(subjects, {RelationKind::on, *carrier, "", false});
    reading_.talk.locate(subjects, placement, place);
  }
  // "flanked by two lamps", "holds a vase": the subject is the target.
  void read_inverse(const Attachment& attachment, const SaidPlacement& said) {
    const auto owner = reading_.mention_of(attachment.from),
               thing = reading_.mention_of(attachment.to);
    if (!owner || !thing || *owner == *thing) return;
    if (owned_.says_each(attachment) ? owned_.is_past_each(attachment) : owned_.goes_on_about_room(attachment)) return;
    const Indices things = reading_.all_of(attachment.to);
    if (owned_.says_each(attachment)) shares_.give_each(*owner, things, attachment.tokens.begin);
    for (const std::size_t one : things)
      for (auto kind : said.placement->relations)
        reading_.talk.add(one, {kind, *owner, "", said.placement->flank, is_among_several(attachment),
                                which_of(reading_, attachment.from)});
  }
  // "flanked by a dishwasher and a pantry": each takes a side.
  bool is_among_several(const Attachment& attachment) const {
    return std::count_if(reading_.parse.attachments.begin(), reading_.parse.attachments.end(),
                         [&](const Attachment& other) {
                           return other.from == attachment.from &&
                                  other.tokens == attachment.tokens;
                         }) > 1;
  }
  PromptReading& reading_;
  ShareReader shares_;
  OwnedReader owned_;
  PlaceTeller teller_;
  PlaceAdverbs adverbs_;
};

}  // namespace

void read_places(PromptReading& reading) {
  PlaceReader(reading).run();
}

}  // namespace roomgen::brief
