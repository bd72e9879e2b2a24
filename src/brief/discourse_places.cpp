// Where things are said to be in the room: the part of Discourse that knows walls, windows, corners and ceilings.
#include <algorithm>

#include "discourse.h"
#include "mention_shape.h"

namespace roomgen::brief {

namespace {

// The walls that there are two of, as plans name them.
std::pair<const char*, const char*> walls_of(Discourse::Both both) {
  if (both == Discourse::Both::side_walls) return {"wall-3", "wall-1"};
  if (both == Discourse::Both::short_walls) return {"short-wall", "other-short-wall"};
  return {"long-wall", "other-long-wall"};
}

}  // namespace

void Discourse::locate(const std::vector<std::size_t>& subjects, const Placement& placement,
                       const PlacePhrase& place) {
  const RelationKind first = placement.relations.front();
  const auto say = [&](RelationKind kind, const char* part) {
    demand(subjects, {kind, Demand::none, part, false});
  };
  switch (place.place) {
    case Place::window:
      return locate_at_window(subjects, placement);
    case Place::door:
      if (placement.flank) return demand(subjects, {first, Demand::none, "door-0", true});
      for (auto kind : placement.relations)
        if (kind != RelationKind::side_of && kind != RelationKind::on) say(kind, "door-0");
      return;
    case Place::corner:
      if (first == RelationKind::on || first == RelationKind::near ||
          first == RelationKind::next_to) {
        say(RelationKind::corner, "");
        if (!place.region.empty()) say(RelationKind::in_part, place.region.c_str());
      }
      return;
    case Place::region:
      if (first != RelationKind::face_to && first != RelationKind::far)
        say(RelationKind::in_part, place.region.c_str());
      return;
    case Place::middle:
      return say(RelationKind::middle, "");
    case Place::wall: {
      PlacePhrase wall = place;
      wall.centered = wall.centered || first == RelationKind::center_aligned;  // "centred on the long wall"
      return locate_at_wall(subjects, first, wall);
    }
    case Place::ceiling:
      return hang_at_ceiling(subjects, first);
    case Place::room:
      if (placement.centered) say(RelationKind::middle, "");
      return;
    case Place::floor:
      // "On the floor, two books": small things that nothing carries.
      if (first == RelationKind::on) mount(subjects, Mount::floor);
      return;
  }
}

// "A lamp on the ceiling", but not "shelves up to the ceiling"; a table never hangs.
void Discourse::hang_at_ceiling(const std::vector<std::size_t>& subjects, RelationKind relation) {
  if (relation == RelationKind::near) return;
  std::vector<std::size_t> hanging;
  for (const std::size_t subject : subjects)
    if (!lexicon_.table.is_any_of(mention(subject).category, {"seat", "table", "storage", "bed"}))
      hanging.push_back(subject);
  mount(hanging, Mount::ceiling);
}

void Discourse::hang_from_ceiling(const std::vector<std::size_t>& subjects) {
  for (const std::size_t subject : subjects) {
    Mention& mention = brief_.mentions[subject];
    const bool can_hang = !lexicon_.table.get(mention.category).forms.ceiling.empty();
    if (can_hang && mention.mount != Mount::wall) hang(mention, Mount::ceiling, lexicon_.table);
  }
}

void Discourse::locate_at_window(const std::vector<std::size_t>& subjects,
                                 const Placement& placement) {
  const RelationKind first = placement.relations.front();
  if (first == RelationKind::between) {
    brief_.windows = std::max(2, brief_.windows.value_or(0));
    for (const char* window : {"window-0", "window-1"})
      demand(subjects, {RelationKind::between, Demand::none, window, false});
    return;
  }
  if (!brief_.windows) brief_.windows = 1;
  // "an armchair on each side of the window"
  if (placement.flank) return demand(subjects, {first, Demand::none, "window-0", true});
  // "opposite the window" looks at it from the other side of the room; "under the window" and "on the window" are before it.
  const bool is_across = placement.relations.size() > 1 && placement.relations.back() == RelationKind::far;
  const bool before = !is_across && ( first == RelationKind::under || first == RelationKind::on ||
                                     first == RelationKind::in_front_of);
  auto relations = placement.relations;
  if (before) relations = {RelationKind::near, RelationKind::in_front_of};
  if (first == RelationKind::face_same_as) demand(subjects, {RelationKind::near, Demand::none, "window-0", false});  // the back to it
  for (auto kind : relations)
    if (kind != RelationKind::side_of) demand(subjects, {kind, Demand::none, "window-0", false});
}

void Discourse::locate_at_wall(const std::vector<std::size_t>& subjects, RelationKind first,
                               const PlacePhrase& place) {
  if (first == RelationKind::far || first == RelationKind::face_to) return;
  if (first == RelationKind::on) mount(subjects, Mount::wall);
  const std::string id = wall_named(place);
  demand_at_wall(subjects, id);
  if (!id.empty()) {
    if (place.centered) demand_middle_of(subjects, id);
  } else if (place.opposite && !subjects.empty()) {
    if (const auto other = antecedent(subjects))
      for (auto kind : {RelationKind::in_front_of, RelationKind::face_to, RelationKind::far})
        demand(subjects, {kind, *other, "", false});
  }
}

// With the back to a wall: to that one, unless its name is empty.
void Discourse::demand_at_wall(const Indices& subjects, const std::string& wall) {
  demand(subjects, {RelationKind::edge, Demand::none, "", false});
  if (wall.empty()) return;
  for (auto kind : {RelationKind::near, RelationKind::face_same_as}) demand(subjects, {kind, Demand::none, wall, false});
}

// The centre of the wall's middle, wherever along it that is: before it, and in line with it.
void Discourse::demand_middle_of(const std::vector<std::size_t>& subjects, const std::string& wall) {
  Demand before{RelationKind::in_front_of, Demand::none, wall, false};
  before.is_means = true;
  demand(subjects, before);
  demand(subjects, {RelationKind::center_aligned, Demand::none, wall, false});
}

std::pair<Indices, Indices> Discourse::halves(const Indices& subjects) {
  std::pair<Indices, Indices> halves;
  if (subjects.size() > 1) {
    for (std::size_t i = 0; i < subjects.size(); ++i) (i % 2 == 0 ? halves.first : halves.second).push_back(subjects[i]);
    return halves;
  }
  for (const std::size_t subject : subjects) {
    int& quantity = brief_.mentions[subject].quantity;
    quantity = std::max(2, quantity);
    const std::size_t half = part(subject, quantity / 2);
    halves.first.push_back(subject);
    if (half != subject) halves.second.push_back(half);
  }
  return halves;
}

void Discourse::locate_at_both(const Indices& subjects, Both both) {
  const auto [one, other] = halves(subjects);
  if (both == Both::ends) {
    demand(one, {RelationKind::in_part, Demand::none, "one-end", false});
    demand(other, {RelationKind::in_part, Demand::none, "other-end", false});
    return;
  }
  const auto [wall, opposite] = walls_of(both);
  demand_at_wall(one, wall);
  demand_at_wall(other, opposite);
}

void Discourse::mount(const std::vector<std::size_t>& subjects, Mount where) {
  for (const std::size_t subject : subjects) {
    Mention& mention = brief_.mentions[subject];
    hang(mention, where, lexicon_.table);
    if (mention.mount == where && told_by_ != HeardWords::none) mention.mount_heard = told_by_;
  }
}

}  // namespace roomgen::brief
