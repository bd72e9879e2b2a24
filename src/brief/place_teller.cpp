#include "place_teller.h"

#include <algorithm>

#include "place_readers.h"
#include "view_from_door.h"

namespace roomgen::brief {

using language::none;
using language::Run;

bool is_beside(const Placement& placement) {
  return placement.relations.size() == 1 && (placement.relations.front() == RelationKind::left_of ||
                                             placement.relations.front() == RelationKind::right_of);
}

PlaceTeller::PlaceTeller(PromptReading& reading, const OwnedReader& owned)
    : reading_(reading), owned_(owned), views_(views_from_door(reading)) {}

void PlaceTeller::say(const Indices& subjects, const SaidPlacement& said, std::size_t target) {
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
  if (is_at_table(said, target)) return say_at_table(subjects, said, target);
  const Placement& placement = at_long_sides(*said.placement, subjects, target);
  for (auto kind : placement.relations)
    reading_.talk.demand(subjects, {kind, target, "", placement.flank, false, which_of(reading_, said.target)});
  if (is_beside(*said.placement)) last_side_ = {said.placement->relations.front(), target};
}

// "a chair and a monitor at each desk": one sits at it, what stands on things is on it.
bool PlaceTeller::is_at_table(const SaidPlacement& said, std::size_t target) const {
  return said.placement->seated && reading_.text.table.is_any_of(reading_.talk.mention(target).category, {"table", "desk"});
}

void PlaceTeller::say_at_table(const Indices& subjects, const SaidPlacement& said, std::size_t target) {
  for (const std::size_t subject : subjects) {
    const Mention& one = reading_.talk.mention(subject);
    const bool is_seat = one.category == "seat" || reading_.text.table.is_any_of(one.category, {"chair", "stool"});
    const RelationKind kind = is_seat ? RelationKind::around
                              : one.mount == Mount::surface ? RelationKind::on
                                                            : said.placement->relations.front();
    reading_.talk.demand({subject}, {kind, target, "", false, subjects.size() > 1, which_of(reading_, said.target)});
  }
}

// Seats on each side of a table stand at its long sides.
const Placement& PlaceTeller::at_long_sides(const Placement& placement, const Indices& subjects, std::size_t target) const {
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

bool PlaceTeller::stands_on(std::size_t mention, std::size_t target) const {
  const auto& demands = reading_.talk.mention(mention).demands;
  return std::any_of(demands.begin(), demands.end(), [&](const Demand& demand) {
    return demand.kind == RelationKind::on && demand.mention == target;
  });
}

std::optional<std::size_t> PlaceTeller::implied(RelationKind kind, const Indices& subjects) const {
  return reading_.talk.antecedent(kind, with_kin(subjects));
}

// Subjects, and what they are some of: none of them is what they stand beside.
Indices PlaceTeller::with_kin(const Indices& subjects) const {
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

void PlaceTeller::say_of_implied(const Indices& subjects, const Placement& placement) {
  const RelationKind first = placement.relations.front();
  auto target = implied(first, subjects);
  if (is_beside(placement) && !owned_.owner_of(subjects.front()) && (!target || is_seen_from_door() || hangs_over(*target, subjects))) {
    const int wall = first == RelationKind::left_of ? left_wall : right_wall;
    PlacePhrase half;
    half.place = Place::region, half.region = half_at(wall);
    return reading_.talk.locate(subjects, placement, half);
  }
  if (const auto same = placement.pronoun && is_beside(placement) ? told_by_it(subjects) : std::nullopt) target = same;
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
bool PlaceTeller::hangs_over(std::size_t target, const Indices& subjects) const {
  const Mount mount = reading_.talk.mention(target).mount;
  return (mount == Mount::wall || mount == Mount::ceiling) && std::all_of(subjects.begin(), subjects.end(), [&](std::size_t one) {
           return reading_.talk.mention(one).mount == Mount::floor && !reading_.talk.is_small(one);
         });
}

// "On the left as you come in there is a rack, on the right a bench": of who enters, until the sentence ends.
bool PlaceTeller::is_seen_from_door() const {
  return std::any_of(views_.begin(), views_.end(), [&](const Run& view) {
    const auto here = reading_.sentence_of(place_at_);
    return reading_.sentence_of(view.begin) == here || (view.begin < place_at_ && reading_.sentence_of(view.begin) + 1 == here);
  });
}

// "a chair by the window, a lamp behind it, a table to its right": what "it" was before in the sentence.
std::optional<std::size_t> PlaceTeller::told_by_it(const Indices& subjects) const {
  for (std::size_t i = reading_.parse.phrases.size(); i-- > 0;) {
    const auto& phrase = reading_.parse.phrases[i];
    if (phrase.head >= place_at_ || !phrase.is_pronoun || !reading_.is_word(phrase.head, "it")) continue;
    if (reading_.sentence_of(phrase.head) != reading_.sentence_of(place_at_)) return std::nullopt;
    const auto same = reading_.mentions[i];
    return same && !is_among(subjects, *same) ? same : std::nullopt;
  }
  return std::nullopt;
}

// "Left of the sofa a lamp, to its right a plant": both stand beside one thing.
std::optional<std::size_t> PlaceTeller::other_side_of(const Placement& placement, const Indices& subjects) const {
  if (!is_beside(placement) || !last_side_ || last_side_->first == placement.relations.front() ||
      is_among(subjects, last_side_->second))
    return std::nullopt;
  return last_side_->second;
}

}  // namespace roomgen::brief
