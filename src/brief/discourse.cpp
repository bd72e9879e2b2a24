#include "discourse.h"

#include <algorithm>

#include "roomgen/base/text.h"
#include "settle.h"

namespace roomgen::design {

namespace {

constexpr std::size_t max_mentions = 120;
constexpr double tray_height = 0.1, tray_side = 0.2;

// Who describes a room looks at the fronts of things: the mouse to the right of a keyboard is at the
// hand of who sits before it. Constraints' sides are the thing's own.
RelationKind as_seen(RelationKind kind) {
  if (kind == RelationKind::left_of) return RelationKind::right_of;
  return kind == RelationKind::right_of ? RelationKind::left_of : kind;
}

}  // namespace

std::string Discourse::category_name(const KindMention& kind) const {
  const auto meant = lexicon_.kind.means.find(kind.name);
  return meant == lexicon_.kind.means.end() ? kind.category->name : meant->second;
}

// "the console" is the media console that was spoken of.
std::optional<std::size_t> Discourse::same_noun(const NounPhrase& phrase) const {
  const std::string& noun = phrase.kind.length > 0 ? phrase.kind.name : phrase.noun;
  for (std::size_t i = count(); i-- > 0;)
    if (mention(i).noun == noun) return i;
  // The first of several is the main one: "the table" is the dining table, not the console table.
  for (std::size_t i = 0; i < count(); ++i)
    if (mention(i).description.ends_with(" " + noun)) return i;
  return std::nullopt;
}

std::optional<std::size_t> Discourse::known(const NounPhrase& phrase) const {
  if (phrase.definite && phrase.modifiers.empty())
    if (const auto same = same_noun(phrase)) return same;
  if (phrase.kind.length > 0) {
    if (const auto same = last_of(phrase.kind)) return same;
    return phrase.definite ? last_compound(phrase.kind.name) : std::nullopt;
  }
  for (std::size_t i = count(); i-- > 0;)
    if (mention(i).category == phrase.noun) return i;
  return std::nullopt;
}

// "The bench" is the workbench, "the cabinet" the filing cabinet.
std::optional<std::size_t> Discourse::last_compound(std::string_view noun) const {
  for (std::size_t i = count(); i-- > 0;)
    if (mention(i).noun.ends_with(noun) || mention(i).category.ends_with(noun)) return i;
  return std::nullopt;
}

std::optional<std::size_t> Discourse::refer(const NounPhrase& phrase) {
  const bool further = std::any_of(phrase.modifiers.begin(), phrase.modifiers.end(),
                                   [&](const std::string& word) { return lexicon_.words.further.count(word) > 0; });
  if (!further && (!phrase.article || phrase.definite))
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
  mention.sentence = sentence_;
  std::vector<std::string> description = phrase.modifiers;
  if (phrase.kind.length > 0) {
    mention.category = category_name(phrase.kind);
    mention.noun = phrase.kind.name;
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
    mention.noun = phrase.noun;
    description.push_back(phrase.noun);
  }
  if (!phrase.contents.empty()) description.push_back(phrase.contents);
  mention.description = join(description, " ");
  shape(mention, phrase, lexicon_.words, lexicon_.table);
  return mention;
}

std::optional<std::size_t> Discourse::antecedent() const {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < count(); ++i)
    if (i != subject_.value_or(count()) && (mention(i).mount == Mount::floor || !best)) best = i;
  return best;
}

std::optional<std::size_t> Discourse::last_on_floor() const {
  for (std::size_t i = count(); i-- > 0;)
    if (mention(i).mount == Mount::floor) return i;
  return std::nullopt;
}

std::optional<std::size_t> Discourse::antecedent(RelationKind kind) const {
  if (!subject_) return antecedent();
  const Mention& one = mention(*subject_);
  if (one.mount == Mount::ceiling || kind == RelationKind::above || kind == RelationKind::under)
    if (const auto carrier = last_carrier()) return carrier;
  // Chairs stand before desks and tables.
  if (kind == RelationKind::in_front_of && lexicon_.table.is_a(one.category, "seat"))
    if (const auto table = last_carrier("table")) return table;
  // On a desk the mouse to the right is to the right of the keyboard.
  if (one.mount == Mount::surface && kind != RelationKind::on)
    for (std::size_t i = *subject_; i-- > 0 && mention(i).sentence + 1 >= one.sentence;)
      if (mention(i).mount == Mount::surface && !(plural_ && is_listed(i))) return i;
  return antecedent();
}

void Discourse::list(std::size_t mention, bool continues) {
  if (!continues || group_placed_) group_.clear();
  group_placed_ = false;
  group_.push_back(mention);
}

bool Discourse::is_listed(std::size_t index) const {
  return std::find(group_.begin(), group_.end(), index) != group_.end();
}

std::vector<std::size_t> Discourse::subjects() const {
  if (!subject_) return {};
  return plural_ && is_listed(*subject_) ? group_ : std::vector<std::size_t>{*subject_};
}

void Discourse::demand(const Demand& what, bool leads) {
  if (leads) {
    leading_.push_back(what);
    return;
  }
  auto all = subjects();
  group_placed_ = true;
  // Of a desk, a lamp and a cup on it only the small ones are meant.
  if (all.size() > 1 && what.kind == RelationKind::on)
    std::erase_if(all, [this](std::size_t i) { return i != *subject_ && !is_small(i); });
  for (std::size_t subject : all) {
    Demand own = what;
    own.shared = own.shared || all.size() > 1;
    add(subject, own);
  }
}

void Discourse::put_on_what_was_named() {
  const auto carrier = antecedent();
  if (!carrier) return;
  const auto stands_alone = [&](std::size_t i) {
    const auto& demands = mention(i).demands;
    return mention(i).mount == Mount::surface &&
           std::none_of(demands.begin(), demands.end(),
                        [](const Demand& one) { return one.kind == RelationKind::on; });
  };
  auto things = group_;
  if (std::find(things.begin(), things.end(), *subject_) == things.end()) things = {*subject_};
  for (std::size_t i : things)
    if (i != *carrier && stands_alone(i)) add(i, {RelationKind::on, *carrier, "", false});
}

void Discourse::add(std::size_t index, const Demand& what) {
  if (what.mention == index) return;
  Mention& mention = brief_.mentions[index];
  // "flanked by six chairs, three on each long side": the later is the more exact.
  if (what.flank && what.kind == RelationKind::in_front_of)
    std::erase_if(mention.demands, [&](const Demand& earlier) {
      return earlier.flank && earlier.mention == what.mention && earlier.kind != what.kind &&
             earlier.kind != RelationKind::around;
    });
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
      if (first == RelationKind::on || first == RelationKind::near ||
          first == RelationKind::next_to)
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
      if (placement.centered) demand({RelationKind::middle, Demand::none, "", false}, leads);
      return;
    case Place::floor:
      if (first == RelationKind::on) stand_on_floor(leads);
      return;
  }
}

// What can hang from the ceiling and hangs over a table, hangs there: a lamp, a plant.
void Discourse::hang_lamps(bool leads) {
  if (leads) {
    lamps_hang_ = true;
    return;
  }
  for (std::size_t subject : subjects()) hang_lamp(brief_.mentions[subject]);
}

void Discourse::hang_lamp(Mention& mention) const {
  const bool can_hang = !lexicon_.table.get(mention.category).forms.ceiling.empty();
  if (can_hang && mention.mount != Mount::wall)
    hang(mention, Mount::ceiling, lexicon_.table);
}

// "On the floor, two books": small things that nothing carries.
void Discourse::stand_on_floor(bool leads) {
  if (leads) {
    leading_mount_ = Mount::floor;
    return;
  }
  for (std::size_t subject : subjects()) hang(brief_.mentions[subject], Mount::floor, lexicon_.table);
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
      for (auto kind : {RelationKind::in_front_of, RelationKind::face_to, RelationKind::far})
        demand({kind, *other, "", false}, leads);
  }
}

void Discourse::mount(Mount where, bool leads) {
  if (leads) {
    leading_mount_ = where;
    return;
  }
  for (std::size_t subject : subjects())
    hang(brief_.mentions[subject], where, lexicon_.table);
}

void Discourse::apply_leading(std::size_t index) {
  if (leading_mount_) hang(brief_.mentions[index], *leading_mount_, lexicon_.table);
  leading_mount_.reset();
  if (lamps_hang_) hang_lamp(brief_.mentions[index]);
  lamps_hang_ = false;
  bool used = false;
  for (const auto& what : leading_) {
    if (what.mention == index) continue;
    add(index, what);
    used = true;
  }
  if (used) {
    open_list(leading_);
    leading_.clear();
  }
}

void Discourse::extend_list(std::size_t index) {
  for (auto what : listed_) {
    if (what.mention == index) continue;
    if (what.kind == RelationKind::on && !is_small(index)) {
      // "a table with two benches"
      if (!seats_at(index, what.mention)) continue;
      what.kind = RelationKind::around;
    }
    what.listed = true;
    add(index, what);
  }
}

bool Discourse::seats_at(std::size_t seat, std::size_t other) const {
  const auto& table = lexicon_.table;
  return other != Demand::none && table.is_any_of(mention(seat).category, {"chair", "stool", "bench"}) &&
         table.is_a(mention(other).category, "table") && !table.is_a(mention(other).category, "desk");
}

bool Discourse::is_small(std::size_t index) const {
  const Mention& one = mention(index);
  return one.mount == Mount::surface || !lexicon_.table.get(one.category).forms.small.empty() ||
         (one.mount == Mount::floor && one.size.maxCoeff() <= small_side &&
          !lexicon_.table.is_any_of(one.category, {"seat", "table", "storage"}));
}

std::optional<std::size_t> Discourse::last_of(const KindMention& kind) const {
  if (kind.length == 0) return std::nullopt;
  const std::string name = category_name(kind);
  for (std::size_t i = count(); i-- > 0;)
    if (mention(i).known && (lexicon_.table.is_a(mention(i).category, name) ||
                             lexicon_.table.is_a(name, mention(i).category)))
      return i;
  return std::nullopt;
}

bool Discourse::may_carry(std::size_t index) const {
  const Mention& one = mention(index);
  const bool tray = one.size.z() <= tray_height && one.size.head<2>().minCoeff() >= tray_side;
  return one.mount == Mount::floor || (one.mount == Mount::surface && tray);
}

std::optional<std::size_t> Discourse::holder() const {
  if (!subject_ || !with_owner_) return subject_;
  const Mention& one = mention(*subject_);
  const bool unable = one.quantity != 1 || one.mount == Mount::surface ||
                      lexicon_.table.is_a(one.category, "seat");
  return unable ? with_owner_ : subject_;
}

bool Discourse::speak_of_one_of_them(bool other) {
  for (std::size_t i = count(); i-- > 0;) {
    const int quantity = mention(i).quantity;
    if (quantity < 2 || mention(i).mount != Mount::floor) continue;
    const int next = other ? std::min(last_nth_ + 1, quantity - 1) : 0;
    subject_ = i;
    nth_ = last_nth_ = next;
    return true;
  }
  return false;
}

void Discourse::relate_listed(const Placement& placement) {
  if (group_.size() < 2) return;
  for (auto kind : placement.relations)
    add(group_.back(), {kind, group_[group_.size() - 2], "", false});
}

std::optional<std::size_t> Discourse::last_carrier(std::string_view top) const {
  const auto find = [&](auto test) -> std::optional<std::size_t> {
    for (std::size_t i = count(); i-- > 0;)
      if (mention(i).mount == Mount::floor && test(mention(i))) return i;
    return std::nullopt;
  };
  const bool table = top.starts_with("table"), desk = top.starts_with("desk");
  if (table)
    if (const auto found = find([&](const Mention& one) {
          return one.noun == "table" || one.category == "table" ||
                 lexicon_.table.is_any_of(one.category, {"dining table", "round table"});
        }))
      return found;
  if (top.starts_with("counter"))
    if (const auto found = find([&](const Mention& one) {
          return one.noun.ends_with("counter") || one.noun.ends_with("vanity") ||
                 lexicon_.table.is_any_of(one.category, {"kitchen unit", "kitchen island", "washbasin"});
        }))
      return found;
  if (table || desk)
    if (const auto found = find([&](const Mention& one) {
          return lexicon_.table.is_a(one.category, table ? "table" : "desk");
        }))
      return found;
  return find([&](const Mention& one) {
    return keeps_things(one.category, lexicon_.table);
  });
}

void Discourse::end_sentence() {
  leading_.clear();
  leading_mount_.reset();
  lamps_hang_ = false;
  listed_.clear();
  with_owner_.reset();
  ++sentence_;
}

}  // namespace roomgen::design
