#include "prompt_places.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "prompt_denials.h"
#include "prompt_mutual.h"
#include "prompt_owned.h"
#include "prompt_shares.h"
#include "view_from_door.h"
#include "which_of.h"

namespace roomgen::design {

namespace {

using language::Attachment;
using language::Determiner;
using language::none;
using language::NounPhrase;
using language::Run;

class PlaceReader {
 public:
  explicit PlaceReader(PromptReading& reading)
      : reading_(reading), left_(words_left(reading.parse)), views_(views_from_door(reading)), shares_(reading), owned_(reading, shares_) {}

  void run() {
    for (const auto& attachment : reading_.parse.attachments) {
      read_adverbs(attachment.tokens.begin);
      reading_.look_back_from(attachment.tokens.begin);
      place_at_ = attachment.tokens.begin;
      read_attachment(attachment);
    }
    read_adverbs(reading_.text.plain.size());
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
    if (said->placement->mutual) return relate_mutually(reading_, subjects, *said->placement);
    if (said->placement->flank && is_of_room(attachment.to)) return reading_.talk.locate_at_both(subjects, Discourse::Both::ends);
    if (said->placement->flank) shares_.give_each_side(attachment, reading_.all_of(attachment.from));
    if (said->target == none) {
      if (said->placement->flank && stand_owners_beside(subjects, attachment, *said->placement)) return;
      // "a throne, six columns down each side": where no table has them at its sides, the room has.
      if (said->placement->flank && said->placement->relations.front() == RelationKind::around && !are_at_table(*said->placement, subjects))
        return reading_.talk.locate_at_both(subjects, Discourse::Both::side_walls);
      return relate_to_implied(subjects, *said->placement);
    }
    read_target(attachment, *said, subjects);
  }
  bool are_at_table(const Placement& placement, const Indices& subjects) const {
    const auto what = reading_.talk.antecedent(placement.relations.front(), with_kin(subjects));
    return what && reading_.text.table.is_any_of(reading_.talk.mention(*what).category, {"table", "kitchen island"});
  }
  // "a bar with seven stools along the back wall": where seats and what they are at are told of, the place is said of what
  // they are at.
  Indices whom_place_means(const Attachment& attachment, const SaidPlacement& said) const {
    const Indices subjects = reading_.subjects_of(attachment);
    if (subjects.size() != 1 || said.target == none) return subjects;
    if (const auto target = reading_.mention_of(said.target)) {
      const auto carrier = owned_.owner_of(subjects.front());
      return carrier && carrier != target && is_said_of_carrier(attachment, said, *carrier) ? Indices{*carrier} : subjects;
    }
    const auto owner = owned_.owner_of(subjects.front());
    const auto place = reading_.place_named(reading_.phrase(said.target));
    const bool is_seat = reading_.text.table.is_any_of(reading_.talk.mention(subjects.front()).category, {"chair", "stool"});
    // "a barrel with two glasses on top in the middle"
    const bool is_told_on_it = owner && place && place->place != Place::wall && place->place != Place::ceiling && stands_on(subjects.front(), *owner);
    if (!place || !owner || !(is_seat || is_told_on_it) || place->place == Place::floor) return subjects;
    return {*owner};
  }
  // "a cake with six candles on the table", "a board with tools over the bench": of what small things are with, where
  // something known is named ("a board with tools on a rail": the tools are on that).
  bool is_said_of_carrier(const Attachment& attachment, const SaidPlacement& said, std::size_t carrier) const {
    const NounPhrase& target = reading_.phrase(said.target);
    const bool is_with = std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(), [&](const Attachment& with) {
      return with.to == attachment.from && reading_.owns(with) && reading_.mention_of(with.from) == carrier && !with.is_verb;
    });
    const bool is_behind = reading_.phrase(attachment.from).head + 1 == attachment.tokens.begin;
    return is_with && is_behind && !target.is_pronoun && target.determiner == Determiner::definite && !said.placement->flank &&
           reading_.talk.is_small(*reading_.mention_of(attachment.from));
  }
  // "a bed, a nightstand with a lamp on each side": the nightstands are at the sides of the bed, each with its lamp.
  bool stand_owners_beside(const Indices& subjects, const Attachment& attachment, const Placement& placement) {
    const bool may_stand_on_it = subjects.size() == 1 && (reading_.talk.is_small(subjects.front()) ||
                                                         reading_.text.table.is_a(reading_.talk.mention(subjects.front()).category, "lamp"));
    if (!may_stand_on_it) return false;
    const auto owner = owned_.owner_of(subjects.front());
    if (!owner || reading_.talk.mention(*owner).mount != Mount::floor) return false;
    const std::size_t carrier = *owner;
    const auto target = reading_.talk.antecedent(placement.relations.front(), with_kin({carrier, subjects.front()}));
    if (!target) return false;
    say({carrier}, {&placement, none, false}, *target);
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
  static bool is_beside(const Placement& placement) {
    return placement.relations.size() == 1 && (placement.relations.front() == RelationKind::left_of ||
                                               placement.relations.front() == RelationKind::right_of);
  }
  // "the crib's left", "its right end": beside what owns the side.
  bool stand_beside_owner(const NounPhrase& phrase, const Indices& subjects) {
    const Placement* side = side_named(phrase);
    if (!side) return false;
    if (phrase.determiner == Determiner::possessive) return relate_to_implied(subjects, *side), true;
    const auto owner = owner_named(phrase);
    if (!owner || is_among(subjects, *owner)) return false;
    say(subjects, {side, none, false}, *owner);
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
  void read_target(const Attachment& attachment, const SaidPlacement& said,
                   const Indices& subjects) {
    if (stand_beside_owner(reading_.phrase(attachment.to), subjects)) return;
    if (const auto* place = shares_.place_having(subjects.front()); place && reading_.phrase(said.target).is_pronoun)
      return reading_.talk.locate(subjects, *said.placement, *place);
    const NounPhrase& target = reading_.phrase(said.target);
    if (const auto thing = reading_.mention_of(said.target)) {
      if (const auto some = shares_.number_of_some(*thing, target, said.placement->relations.front() == RelationKind::between))
        shares_.give_some(*some, subjects, target);
      else if (target.determiner == Determiner::each &&
          said.placement->relations.front() != RelationKind::aligned)
        shares_.give_each(*thing, with_small_before(attachment, subjects), attachment.tokens.begin);
      if (is_all(target) && !reading_.talk.mention(subjects.front()).counted)
        shares_.give_each(*thing, subjects, attachment.tokens.begin);
      if (is_own(target) && reading_.talk.mention(*thing).quantity == 1)
        shares_.give_each(subjects.front(), {*thing}, attachment.tokens.begin);
      say(subjects, said, *thing);
      for (const std::size_t further : reading_.also[static_cast<std::size_t>(said.target)])
        if (reaches_all(said.placement->relations.front()) && !is_among(subjects, further)) say(subjects, said, further);
      return;
    }
    if (said.placement->relations.front() == RelationKind::face_to && reading_.is_somebody(target))
      if (const auto seats = seats_of_several()) return say(subjects, said, *seats);
    if (is_way_in(target, *said.placement))
      return reading_.talk.locate(subjects, *said.placement, PlacePhrase{.place = Place::door});
    if (const auto both = both_places(attachment, said)) return locate_at_both(subjects, *both, target.determiner == Determiner::each);
    if (reading_.is_room(target)) {
      if (said.placement->centered) reading_.talk.locate(subjects, *said.placement, PlacePhrase{});
      return;
    }
    auto place = reading_.place_named(target);
    if (!place) return;
    if (place->place == Place::region && place->side >= 0 && is_along(attachment)) place->place = Place::wall, place->wall = place->side;
    if (target.determiner == Determiner::possessive && is_portion(*place))
      return lie_on_owner(subjects);
    if (target.determiner == Determiner::each) shares_.give_each_place(*place, subjects, attachment.tokens.begin);
    if (place->place == Place::middle)
      return locate_in_middle(attachment, subjects, *said.placement, *place);
    reading_.talk.locate(subjects, *said.placement, *place);
  }
  // "four shelves along each long wall" are eight.
  void locate_at_both(const Indices& subjects, Discourse::Both both, bool at_each) {
    for (const std::size_t subject : subjects)
      if (at_each && reading_.talk.mention(subject).counted && reading_.talk.mention(subject).quantity > 1) reading_.talk.multiply(subject, 2);
    reading_.talk.locate_at_both(subjects, both);
  }
  // "at opposite ends of the room", "along both long walls": places that there are two of.
  std::optional<Discourse::Both> both_places(const Attachment& attachment, const SaidPlacement& said) const {
    static const WordSet twos = {"both", "two", "opposite", "opposing", "each", "either"}, ends = {"end", "ends", "sides"};
    const NounPhrase& target = reading_.phrase(said.target);
    if (reading_.is_room(target) && said.placement->flank) return Discourse::Both::ends;
    bool are_two = false, are_sides = false;
    for (auto i = std::min(target.tokens.begin, attachment.tokens.begin); i < target.head; ++i) {
      are_two = are_two || twos.count(reading_.word(i));
      are_sides = are_sides || reading_.is_word(i, "side");
    }
    if (are_two && ends.count(reading_.word(target.head)) && is_of_room(said.target)) return Discourse::Both::ends;
    if (said.placement->relations.front() == RelationKind::face_to) return std::nullopt;
    const auto place = reading_.place_named(target);
    if (!place || place->place != Place::wall) return std::nullopt;
    const bool is_either = target.determiner == Determiner::each || reading_.is_word(target.tokens.begin, "either");
    if (!(target.is_plural || is_either) || (!are_two && !are_sides && place->length_of_wall.empty())) return std::nullopt;
    if (place->length_of_wall == "short") return Discourse::Both::short_walls;
    return are_sides ? Discourse::Both::side_walls : Discourse::Both::long_walls;
  }
  // "the ends of the room"
  bool is_of_room(std::int32_t part) const {
    return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(), [&](const Attachment& of) {
      return of.from == part && of.relation == "of" && reading_.is_room(reading_.phrase(of.to));
    });
  }
  // "a monitor and keyboard on each": the small things of the list that were named before.
  Indices with_small_before(const Attachment& attachment, Indices subjects) const {
    for (const auto id : reading_.parse.with_list(static_cast<std::uint32_t>(attachment.from))) {
      const auto mention = reading_.mention_of(static_cast<std::int32_t>(id));
      const bool is_meant = mention && static_cast<std::int32_t>(id) < attachment.from && reading_.talk.is_small(*mention) &&
                            !owned_.is_told_somewhere(static_cast<std::int32_t>(id));
      if (is_meant && !is_among(subjects, *mention)) subjects.push_back(*mention);
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
    reading_.talk.locate(subjects, placement, place);
  }
  void say(const Indices& subjects, const SaidPlacement& said, std::size_t target) {
    if (said.placement->hanging) reading_.talk.hang_from_ceiling(subjects);
    const bool lies_on_part =
        said.is_portion && std::all_of(subjects.begin(), subjects.end(), [&](std::size_t i) {
          return reading_.talk.mention(i).mount == Mount::surface;
        });
    if (lies_on_part) return reading_.talk.demand(subjects, {RelationKind::on, target, "", false});
    // "two speakers on the console, one at either end": not beside it.
    const bool is_on_it = said.placement->flank && std::all_of(subjects.begin(), subjects.end(), [&](std::size_t i) {
      return stands_on(i, target);
    });
    if (is_on_it) return;
    const Placement& placement = at_long_sides(*said.placement, subjects, target);
    for (auto kind : placement.relations)
      reading_.talk.demand(subjects, {kind, target, "", placement.flank, false, which_of(reading_, said.target)});
    if (is_beside(*said.placement)) last_side_ = {said.placement->relations.front(), target};
  }
  // Seats on each side of a table stand at its long sides.
  const Placement& at_long_sides(const Placement& placement, const Indices& subjects, std::size_t target) const {
    const auto& table = reading_.text.table;
    const auto found = reading_.words.placements.find("on each long side of");
    const bool are_seats = placement.flank && placement.relations.front() == RelationKind::next_to &&
                           std::all_of(subjects.begin(), subjects.end(), [&](std::size_t one) {
                             return table.is_any_of(reading_.talk.mention(one).category, {"chair", "stool", "bench"});
                           });
    const std::string& what = reading_.talk.mention(target).category;
    return are_seats && found != reading_.words.placements.end() && table.is_a(what, "table") && !table.is_a(what, "desk")
               ? found->second
               : placement;
  }
  bool stands_on(std::size_t mention, std::size_t target) const {
    const auto& demands = reading_.talk.mention(mention).demands;
    return std::any_of(demands.begin(), demands.end(), [&](const Demand& demand) {
      return demand.kind == RelationKind::on && demand.mention == target;
    });
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
  // Subjects, and what they are some of: none of them is what they stand beside.
  Indices with_kin(const Indices& subjects) const {
    Indices all = subjects;
    for (const std::size_t subject : subjects) {
      const std::size_t whole = reading_.talk.mention(subject).part_of;
      for (const std::size_t kin : reading_.talk.with_parts(whole == Demand::none ? subject : whole))
        if (!is_among(all, kin)) all.push_back(kin);
      for (std::size_t other = 0; other < subject; ++other)
        if (reading_.talk.mention(other).description == reading_.talk.mention(subject).description && !is_among(all, other))
          all.push_back(other);
    }
    return all;
  }
  // "to its left", "overhead": of what was spoken of before.
  void relate_to_implied(const Indices& subjects, const Placement& placement) {
    const RelationKind first = placement.relations.front();
    auto target = reading_.talk.antecedent(first, with_kin(subjects));
    if (is_beside(placement) && !owned_.owner_of(subjects.front()) && (!target || is_seen_from_door() || hangs_over(*target, subjects))) {
      const int wall = first == RelationKind::left_of ? left_wall : right_wall;
      PlacePhrase half;
      half.place = Place::region, half.region = half_at(wall);
      return reading_.talk.locate(subjects, placement, half);
    }
    if (placement.owner.empty()) {
      if (const auto other = other_side_of(placement, subjects)) target = other;
    } else if (const auto owner = reading_.talk.last_of_category(placement.owner, subjects)) {
      target = owner;
    }
    // "a board with a knife on top", "a bed with a nightstand on one side"
    if (const auto owner = owned_.owner_of(subjects.front())) target = owner;
    // "a galley kitchen, cabinets on both sides": nothing was named that has sides.
    if (!target && placement.flank && subjects == Indices{0}) return reading_.talk.locate_at_both(subjects, Discourse::Both::side_walls);
    if (target) say(subjects, {&placement, none, false}, *target);
  }
  // "A mirror on the wall. On the left, a pew": what stands is at a side of the room, not of what hangs.
  bool hangs_over(std::size_t target, const Indices& subjects) const {
    const Mount mount = reading_.talk.mention(target).mount;
    return (mount == Mount::wall || mount == Mount::ceiling) && std::all_of(subjects.begin(), subjects.end(), [&](std::size_t one) {
             return reading_.talk.mention(one).mount == Mount::floor && !reading_.talk.is_small(one);
           });
  }
  // "On the left as you come in there is a rack, on the right a bench": of who enters, until the sentence ends.
  bool is_seen_from_door() const {
    return std::any_of(views_.begin(), views_.end(), [&](const Run& view) {
      const auto here = reading_.sentence_of(place_at_);
      return reading_.sentence_of(view.begin) == here || (view.begin < place_at_ && reading_.sentence_of(view.begin) + 1 == here);
    });
  }
  // "Left of the sofa a lamp, to its right a plant": both stand beside one thing.
  std::optional<std::size_t> other_side_of(const Placement& placement, const Indices& subjects) const {
    if (!is_beside(placement) || !last_side_ || last_side_->first == placement.relations.front() ||
        is_among(subjects, last_side_->second))
      return std::nullopt;
    return last_side_->second;
  }
  // Words that no phrase has and no attachment.
  static std::vector<bool> words_left(const language::Parse& parse) {
    std::vector<bool> left(parse.tokens.size(), true);
    const auto use = [&](const Run& run) {
      std::fill(left.begin() + run.begin, left.begin() + run.end, false);
    };
    for (const auto& one : parse.attachments) use(one.tokens);
    for (const auto& one : parse.phrases) use({one.tokens.begin, one.head + 1});
    return left;
  }
  // "nearby", "on top", "side by side": those up to a token that were not read yet.
  void read_adverbs(std::size_t end) {
    for (; next_adverb_ < end; ++next_adverb_) {
      const std::size_t i = next_adverb_;
      const auto match = longest(reading_.words.placements, reading_.text.plain, i);
      if (!left_[i] && !(match && is_doubled(i, match.length))) continue;
      reading_.look_back_from(i);
      place_at_ = static_cast<std::uint32_t>(i);
      if (!match || (!match.value->pronoun && !match.value->adverb && !match.value->mutual))
        continue;
      // "Between sofa and console: a table" names what it is between.
      const bool goes_on = i + match.length < reading_.text.plain.size() && reading_.text.plain[i + match.length].kind == Token::Kind::word;
      if (goes_on && match.value->relations.front() == RelationKind::between) continue;
      const Indices subjects = subjects_at(i);
      const auto first = static_cast<std::uint32_t>(i);
      const auto heard = hear(reading_.brief, {first, first + static_cast<std::uint32_t>(match.length)},
                              Heard::As::relation);
      reading_.talk.told_by(heard);
      if (!subjects.empty() && match.value->mutual)
        relate_listed(reading_, i, *match.value, heard);
      else if (!subjects.empty())
        relate_to_implied(subjects, *match.value);
      next_adverb_ += match.length - 1;
    }
  }
  // "back to back", whatever noun it is made of.
  bool is_doubled(std::size_t first, std::size_t length) const {
    return length == 3 && reading_.text.plain[first].text == reading_.text.plain[first + 2].text;
  }
  // Of what an adverb is said: the subject of the verb before it, what was named last in its
  // sentence, or what it is said before ("Above hangs a lantern").
  Indices subjects_at(std::size_t token) const {
    for (const auto& verb : reading_.parse.verbs)
      if (verb.tokens.end == token && verb.subject != none)
        if (const auto subjects = reading_.mentions_of_list(verb.subject); !subjects.empty())
          return subjects;
    std::optional<std::size_t> before, after;
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) {
      const std::size_t head = reading_.parse.phrases[i].head;
      if (!reading_.mentions[i] || reading_.sentence_of(head) != reading_.sentence_of(token))
        continue;
      if (head < token)
        before = reading_.mentions[i];
      else if (!after)
        after = reading_.mentions[i];
    }
    if (!before) before = after;
    return before ? Indices{*before} : Indices{};
  }
  PromptReading& reading_;
  const std::vector<bool> left_;                 ///< by token
  const std::vector<Run> views_;                 ///< "as you come in"
  std::uint32_t place_at_ = 0;                   ///< the token of what is being read
  std::size_t next_adverb_ = 0;                  ///< token
  std::optional<std::pair<RelationKind, std::size_t>> last_side_;  ///< left or right of which mention
  ShareReader shares_;
  OwnedReader owned_;
};

}  // namespace

void read_places(PromptReading& reading) {
  PlaceReader(reading).run();
}

}  // namespace roomgen::design
