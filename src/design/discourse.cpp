#include "discourse.h"

#include <algorithm>

#include "roomgen/base/text.h"
#include "settle.h"

namespace roomgen::design {

namespace {

constexpr std::size_t max_mentions = 120;

// Who describes a room looks at the fronts of things: the mouse to the right of a keyboard is at the
// hand of who sits before it. Constraints' sides are the thing's own.
RelationKind as_seen(RelationKind kind) {
  if (kind == RelationKind::left_of) return RelationKind::right_of;
  return kind == RelationKind::right_of ? RelationKind::left_of : kind;
}

}  // namespace

std::string Discourse::category_name(const KindMatch& kind) const {
  const auto meant = lexicon_.kind.means.find(kind.name);
  return meant == lexicon_.kind.means.end() ? kind.category->name : meant->second;
}

std::optional<std::size_t> Discourse::known(const NounPhrase& phrase) const {
  for (std::size_t i = count(); i-- > 0;) {
    const Mention& one = mention(i);
    if (phrase.kind.length == 0) {
      if (one.category == phrase.noun) return i;
      continue;
    }
    const std::string name = category_name(phrase.kind);
    if (one.known &&
        (lexicon_.table.is_a(one.category, name) || lexicon_.table.is_a(name, one.category)))
      return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> Discourse::refer(const NounPhrase& phrase) {
  if (!phrase.article || phrase.definite)
    if (const auto before = known(phrase)) return before;
  if (count() >= max_mentions) return std::nullopt;
  brief_.mentions.push_back(new_mention(phrase));
  return count() - 1;
}

Mention Discourse::new_mention(const NounPhrase& phrase) const {
  Mention mention;
  mention.quantity = phrase.count;
  mention.counted = phrase.counted;
  mention.looks = phrase.modifiers;
  std::vector<std::string> description = phrase.modifiers;
  if (phrase.kind.length > 0) {
    mention.category = category_name(phrase.kind);
    description.push_back(phrase.kind.name);
    const bool at_windows = lexicon_.table.get(mention.category).covers_window;
    // "Curtains" are a name of their own, in the plural.
    const bool open = (phrase.kind.plural || at_windows) && !phrase.article;
    if (open) mention.quantity = 0;  // to be settled
    // The two halves of a curtain.
    if (phrase.set && at_windows) mention.quantity = 1;
  } else {
    mention.known = false;
    mention.category = phrase.noun;
    description.push_back(phrase.noun);
  }
  if (!phrase.contents.empty()) description.push_back(phrase.contents);
  mention.description = join(description, " ");
  shape(mention, phrase, lexicon_.words, lexicon_.table, lexicon_.names);
  return mention;
}

std::optional<std::size_t> Discourse::antecedent() const {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < count(); ++i)
    if (i != subject_.value_or(count()) && (mention(i).mount == Mount::floor || !best)) best = i;
  return best;
}

void Discourse::list(std::size_t mention, bool continues) {
  if (!continues) group_.clear();
  group_.push_back(mention);
}

std::vector<std::size_t> Discourse::subjects() const {
  if (!subject_) return {};
  const bool listed = std::find(group_.begin(), group_.end(), *subject_) != group_.end();
  return plural_ && listed ? group_ : std::vector<std::size_t>{*subject_};
}

void Discourse::demand(const Demand& what, bool leads) {
  if (leads) {
    leading_.push_back(what);
    return;
  }
  const auto all = subjects();
  for (std::size_t subject : all) {
    Demand own = what;
    own.shared = own.shared || all.size() > 1;
    add(subject, own);
  }
}

void Discourse::add(std::size_t index, const Demand& what) {
  if (what.mention == index) return;
  Mention& mention = brief_.mentions[index];
  mention.demands.push_back(what);
  mention.demands.back().kind = as_seen(what.kind);
  // "a lamp on each side" is two, but not "a lamp and a plant flank it".
  if (what.flank && !what.shared) mention.quantity = std::max(2, mention.quantity);
}

void Discourse::locate(const Placement& placement, const PlacePhrase& place, bool leads) {
  const RelationKind first = placement.relations.front();
  switch (place.place) {
    case Place::window:
      locate_at_window(placement, leads);
      return;
    case Place::door:
      for (auto kind : placement.relations)
        if (kind != RelationKind::side_of && kind != RelationKind::on)
          demand({kind, Demand::none, "door-0", false}, leads);
      return;
    case Place::corner:
      if (first == RelationKind::on || first == RelationKind::near)
        demand({RelationKind::corner, Demand::none, "", false}, leads);
      return;
    case Place::middle:
      demand({RelationKind::middle, Demand::none, "", false}, leads);
      return;
    case Place::wall:
      locate_at_wall(first, place, leads);
      return;
    case Place::ceiling:
      mount(Mount::ceiling, leads);
      return;
    case Place::room:
    case Place::floor:
      return;
  }
}

void Discourse::locate_at_window(const Placement& placement, bool leads) {
  if (!brief_.windows) brief_.windows = 1;
  const RelationKind first = placement.relations.front();
  // "under the window" and "on the window" are before it.
  const bool before = first == RelationKind::under || first == RelationKind::on ||
                      first == RelationKind::in_front_of;
  auto relations = placement.relations;
  if (before) relations = {RelationKind::near, RelationKind::in_front_of};
  for (auto kind : relations)
    if (kind != RelationKind::side_of) demand({kind, Demand::none, "window-0", false}, leads);
}

void Discourse::locate_at_wall(RelationKind first, const PlacePhrase& place, bool leads) {
  if (first == RelationKind::far || first == RelationKind::face_to) return;
  if (first == RelationKind::on) mount(Mount::wall, leads);
  demand({RelationKind::edge, Demand::none, "", false}, leads);
  if (place.wall >= 0) {
    const std::string id = "wall-" + std::to_string(place.wall);
    demand({RelationKind::near, Demand::none, id, false}, leads);
    demand({RelationKind::face_same_as, Demand::none, id, false}, leads);
  } else if (place.opposite) {
    if (const auto other = antecedent())
      demand({RelationKind::in_front_of, *other, "", false}, leads);
  }
}

void Discourse::mount(Mount where, bool leads) {
  if (leads) {
    leading_mount_ = where;
    return;
  }
  for (std::size_t subject : subjects())
    hang(brief_.mentions[subject], where, lexicon_.table, lexicon_.names);
}

void Discourse::apply_leading(std::size_t index) {
  if (leading_mount_) hang(brief_.mentions[index], *leading_mount_, lexicon_.table, lexicon_.names);
  leading_mount_.reset();
  bool used = false;
  for (const auto& what : leading_) {
    if (what.mention == index) continue;
    add(index, what);
    used = true;
  }
  if (used) leading_.clear();
}

void Discourse::end_sentence() {
  leading_.clear();
  leading_mount_.reset();
}

}  // namespace roomgen::design
