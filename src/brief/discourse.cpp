#include "discourse.h"

#include "roomgen/base/text.h"
#include "mention_shape.h"

namespace roomgen::brief {

namespace {

constexpr std::size_t max_mentions = 120;
constexpr int most_for_each = 40;
constexpr double tray_height = 0.1, tray_side = 0.2;

// Who describes a room looks at the fronts of things: the mouse to the right of a keyboard is at
// the hand of who sits before it. Constraints' sides are the thing's own.
RelationKind as_seen(RelationKind kind) {
  if (kind == RelationKind::left_of) return RelationKind::right_of;
  return kind == RelationKind::right_of ? RelationKind::left_of : kind;
}

}  // namespace

bool is_among(const Indices& indices, std::size_t index) {
  return std::find(indices.begin(), indices.end(), index) != indices.end();
}

std::string Discourse::category_name(const KindMention& kind) const {
  const auto meant = lexicon_.kind.means.find(kind.name);
  if (meant != lexicon_.kind.means.end()) return meant->second;
  return kind.is_stand_in() ? kind.name : kind.category->name;
}

// "the console" is the media console that was spoken of.
std::optional<std::size_t> Discourse::same_noun(const ThingPhrase& phrase) const {
  const std::string& noun = phrase.kind.length > 0 ? phrase.kind.name : phrase.noun;
  for (std::size_t i = made(); i-- > 0;)
    if (mention(i).noun == noun) return i;
  // The first of several is the main one: "the table" is the dining table, not the console table.
  for (std::size_t i = 0; i < made(); ++i)
    if (mention(i).description.ends_with(" " + noun)) return i;
  return std::nullopt;
}

std::optional<std::size_t> Discourse::known(const ThingPhrase& phrase) const {
  if (phrase.definite && phrase.modifiers.empty())
    if (const auto same = same_noun(phrase)) return same;
  if (phrase.kind.length > 0) {
    if (const auto same = last_of(phrase.kind)) return same;
    return phrase.definite ? last_compound(phrase.kind.name) : std::nullopt;
  }
  for (std::size_t i = made(); i-- > 0;)
    if (mention(i).category == phrase.noun) return i;
  return std::nullopt;
}

std::optional<std::size_t> Discourse::one_of(const ThingPhrase& phrase) const {
  if (phrase.definite || phrase.kind.length == 0) return known(phrase);
  const std::string name = category_name(phrase.kind);
  for (std::size_t i = made(); i-- > 0;) {
    const auto& looks = mention(i).looks;
    const bool is_so = std::all_of(phrase.modifiers.begin(), phrase.modifiers.end(), [&](const std::string& word) {
      return std::find(looks.begin(), looks.end(), word) != looks.end();
    });
    if (is_so && (mention(i).category == name || lexicon_.table.is_a(mention(i).category, name))) return i;
  }
  return std::nullopt;
}

// "The bench" is the workbench, "the cabinet" the filing cabinet.
std::optional<std::size_t> Discourse::last_compound(std::string_view noun) const {
  for (std::size_t i = made(); i-- > 0;)
    if (mention(i).noun.ends_with(noun) || mention(i).category.ends_with(noun)) return i;
  return std::nullopt;
}

std::optional<std::size_t> Discourse::refer(const ThingPhrase& phrase, int sentence) {
  const bool further =
      std::any_of(phrase.modifiers.begin(), phrase.modifiers.end(),
                  [&](const std::string& word) { return lexicon_.words.further.count(word) > 0; });
  if (!further && (!phrase.article || phrase.definite))
    if (const auto before = known(phrase); before && !are_others(phrase, *before)) {
      if (!is_other_kind(phrase, *before)) return before;
      const std::string name = category_name(phrase.kind);
      for (std::size_t i = made(); i-- > 0;)
        if (mention(i).category == name && !are_others(phrase, i)) return i;
    }
  if (count() >= max_mentions) return std::nullopt;
  brief_.mentions.push_back(new_mention(phrase, sentence));
  note_reading(phrase.kind);
  note_bound(phrase);
  return count() - 1;
}

// "the judge's bench ..., public benches": several are not the one.
bool Discourse::are_others(const ThingPhrase& phrase, std::size_t known) const {
  const Mention& before = mention(known);
  return phrase.kind.plural && !phrase.definite && before.quantity == 1 && before.noun == phrase.kind.name;
}

// "Washer, dryer, shelf": without an article a name of its own is a thing of its own, however near its kind is.
bool Discourse::is_other_kind(const ThingPhrase& phrase, std::size_t known) const {
  if (phrase.definite || phrase.kind.length == 0) return false;
  const std::string name = category_name(phrase.kind);
  const Mention& before = mention(known);
  // "seats ..., benches", "plants ..., orchids": who says more means others.
  const bool says_more = before.category != name || names_more_than(phrase.kind) || phrase.kind.category->variant;
  if (phrase.kind.plural)
    return says_more && lexicon_.table.is_a(name, before.category) && before.noun != phrase.kind.name && !before.noun.ends_with(phrase.kind.name);
  return before.category != name && !before.category.ends_with(phrase.kind.name) && !before.noun.ends_with(phrase.kind.name);
}

// Numbers beyond what is planned of one kind.
void Discourse::note_bound(const ThingPhrase& phrase) {
  if (phrase.beyond <= 0.0) return;
  brief_.notes.push_back(format_number(phrase.beyond, 0) + " of \"" + brief_.mentions.back().noun + "\" are asked for; at most " +
                         std::to_string(phrase.count) + " of one kind are planned");
}

// What a noun was read as that is no kind's name.
void Discourse::note_reading(const KindMention& kind) {
  if (!kind.misspelt.empty())
    brief_.notes.push_back("read \"" + kind.misspelt + "\" as \"" + kind.name + "\"");
  else if (kind.is_inferred() && !kind.is_stand_in())
    brief_.notes.push_back("\"" + kind.name + "\" is taken for a " + kind.category->name);
}

std::size_t Discourse::part(std::size_t whole, int count) {
  if (this->count() >= max_mentions) return whole;
  Mention part = mention(whole);
  part.quantity = count;
  part.part_of = whole;
  brief_.mentions[whole].quantity -= count;
  brief_.mentions.push_back(std::move(part));
  return this->count() - 1;
}

std::size_t Discourse::another(std::size_t first, int count) {
  if (this->count() >= max_mentions) return first;
  Mention further = mention(first);
  further.quantity = count;
  further.demands.clear();
  further.heard.clear();
  further.formation.reset();
  brief_.mentions.push_back(std::move(further));
  return this->count() - 1;
}

void Discourse::adopt(std::size_t part, std::size_t whole) {
  brief_.mentions[part].part_of = whole;
  brief_.mentions[whole].quantity -= mention(part).quantity;
}

std::vector<std::size_t> Discourse::with_parts(std::size_t index) const {
  std::vector<std::size_t> all{index};
  for (std::size_t i = 0; i < count(); ++i)
    if (mention(i).part_of == index) all.push_back(i);
  return all;
}

void Discourse::multiply(std::size_t mention, int factor) {
  int& quantity = brief_.mentions[mention].quantity;
  if (factor > 1 && factor <= most_for_each) quantity *= factor;
}

void Discourse::expect(std::size_t mention, int count) { brief_.mentions[mention].quantity = count; }

void Discourse::set_count(std::size_t mention, int count) {
  brief_.mentions[mention].quantity = count;
  brief_.mentions[mention].counted = true;
}

void Discourse::describe(std::size_t mention, const std::string& look) {
  Mention& thing = brief_.mentions[mention];
  if (std::find(thing.looks.begin(), thing.looks.end(), look) != thing.looks.end()) return;
  thing.looks.push_back(look);
  thing.description = look + " " + thing.description;
}

Mention Discourse::new_mention(const ThingPhrase& phrase, int sentence) const {
  Mention mention;
  mention.quantity = phrase.count;
  mention.counted = phrase.counted;
  mention.at_least = phrase.at_least;
  mention.at_most = phrase.at_most;
  mention.least = phrase.least, mention.most = phrase.most;
  mention.looks = phrase.modifiers;
  mention.naming = phrase.naming;
  mention.sentence = sentence;
  std::vector<std::string> description = phrase.modifiers;
  if (phrase.kind.length > 0) {
    mention.category = category_name(phrase.kind);
    mention.noun = phrase.kind.name;
    mention.known = !phrase.kind.is_stand_in() || mention.category != phrase.kind.name;
    description.push_back(phrase.kind.name);
    if (names_more_than(phrase.kind)) mention.naming.push_back(phrase.kind.name);
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
  if (phrase.is_full_height) reach_ceiling(mention);
  return mention;
}

// What keeps things stands on the floor then.
void Discourse::reach_ceiling(Mention& mention) const {
  constexpr double share = 0.95;  ///< of the room's height: what must be brought in upright
  language::Measure height;
  height.side = language::Measure::Side::height;
  height.limit = language::Measure::Limit::least;
  height.values[0] = share * brief_.height.value_or(lexicon_.kind.height);
  set_length(mention, height);
  if (mention.mount == Mount::wall &&
      lexicon_.table.is_any_of(mention.category, {"storage", "shelf"}))
    mention.mount = Mount::floor;
}

// "a harp", which a guitar stands for, "a beanie", which is some hat: not every one of the kind is what was named.
bool Discourse::names_more_than(const KindMention& kind) const {
  return kind.basis == NounBasis::hyponym || lexicon_.table.only_resembles(kind.name);
}

std::optional<std::size_t> Discourse::antecedent(const std::vector<std::size_t>& subjects, bool is_one) const {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < made(); ++i) {
    if (is_among(subjects, i) || (is_one && best && mention(i).counted && mention(i).quantity > 1)) continue;
    if (mention(i).mount == Mount::floor || !best) best = i;
  }
  return best;
}

std::optional<std::size_t> Discourse::antecedent(RelationKind kind,
                                                 const std::vector<std::size_t>& subjects) const {
  const Mention& one = mention(subjects.front());
  if (one.mount == Mount::ceiling || kind == RelationKind::above || kind == RelationKind::under ||
      kind == RelationKind::on)
    if (const auto carrier = last_carrier(); carrier && !is_among(subjects, *carrier))
      return carrier;
  // Chairs stand before desks and tables.
  if (kind == RelationKind::in_front_of && lexicon_.table.is_a(one.category, "seat"))
    if (const auto table = last_carrier("table"); table && !is_among(subjects, *table))
      return table;
  // On a desk the mouse to the right is to the right of the keyboard.
  if (one.mount == Mount::surface && kind != RelationKind::on)
    for (std::size_t i = subjects.front(); i-- > 0 && mention(i).sentence + 1 >= one.sentence;)
      if (mention(i).mount == Mount::surface && !is_among(subjects, i)) return i;
  return antecedent(subjects);
}

std::optional<std::size_t> Discourse::last_of_several(const std::vector<std::size_t>& but, bool is_open) const {
  for (std::size_t i = made(); i-- > 0;)
    if ((mention(i).quantity >= 2 || (is_open && mention(i).quantity == 0)) && !is_among(but, i)) return i;
  return std::nullopt;
}

void Discourse::demand(const std::vector<std::size_t>& subjects, const Demand& what) {
  // Of a desk, a lamp and a cup on it only the small ones are meant.
  const bool has_small =
      std::any_of(subjects.begin(), subjects.end(), [this](std::size_t i) { return is_small(i); });
  for (const std::size_t subject : subjects) {
    if (what.kind == RelationKind::on && has_small && !is_small(subject)) continue;
    Demand own = what;
    own.shared = own.shared || subjects.size() > 1;
    add(subject, own);
  }
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
  mention.demands.back().heard = told_by_;
  // "a lamp on each side" is two, but not "a lamp and a plant flank it".
  if (what.flank && !what.shared) mention.quantity = std::max(2, mention.quantity);
}

void Discourse::own(std::size_t owner, std::size_t index, bool is_each, int nth) {
  if (owner == index) return;
  Demand what{RelationKind::on, owner, "", false};
  what.nth = nth;
  if (!is_small(index)) {
    // "a table with two benches"; "beds, each with a locker", "a desk with a chair"
    const bool is_beside = (is_each || works_at(index, owner)) && mention(index).mount == Mount::floor && mention(owner).mount == Mount::floor;
    if (!seats_at(index, owner) && !is_beside) return;
    what.kind = seats_at(index, owner) ? RelationKind::around : RelationKind::near;
  } else if (stands_beside_seat(index, owner)) {
    what.kind = RelationKind::near;
  } else if (!may_carry(owner)) {
    return;
  }
  what.listed = true;
  add(index, what);
}

bool Discourse::seats_at(std::size_t seat, std::size_t other) const {
  const auto& table = lexicon_.table;
  return other != Demand::none &&
         table.is_any_of(mention(seat).category, {"chair", "stool", "bench"}) &&
         table.is_a(mention(other).category, "table");
}

// "an armchair with a lamp": what also stands on the floor does not stand on a seat.
bool Discourse::stands_beside_seat(std::size_t index, std::size_t owner) const {
  const auto& table = lexicon_.table;
  return !table.get(mention(index).category).forms.small.empty() && mention(owner).mount == Mount::floor &&
         table.is_any_of(mention(owner).category, {"seat", "bed"});
}

bool Discourse::works_at(std::size_t seat, std::size_t other) const {
  const auto& table = lexicon_.table;
  return table.is_any_of(mention(seat).category, {"chair", "stool", "bench"}) &&
         !table.is_any_of(mention(other).category, {"seat", "bed"});
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
  for (std::size_t i = made(); i-- > 0;)
    if (mention(i).known && (lexicon_.table.is_a(mention(i).category, name) ||
                             lexicon_.table.is_a(name, mention(i).category)))
      return i;
  return std::nullopt;
}

std::optional<std::size_t> Discourse::last_of_category(const std::string& category,
                                                       const std::vector<std::size_t>& subjects) const {
  for (std::size_t i = made(); i-- > 0;)
    if (!is_among(subjects, i) && lexicon_.table.is_a(mention(i).category, category)) return i;
  return std::nullopt;
}

bool Discourse::may_carry(std::size_t index) const {
  const Mention& one = mention(index);
  const bool tray = one.size.z() <= tray_height && one.size.head<2>().minCoeff() >= tray_side;
  return one.mount == Mount::floor || (one.mount == Mount::surface && tray);
}

std::optional<std::size_t> Discourse::last_carrier(std::string_view top) const {
  const auto find = [&](auto test) -> std::optional<std::size_t> {
    for (std::size_t i = made(); i-- > 0;)
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
                 lexicon_.table.is_any_of(one.category,
                                          {"kitchen unit", "kitchen island", "washbasin"});
        }))
      return found;
  if (table || desk)
    if (const auto found = find([&](const Mention& one) {
          return lexicon_.table.is_a(one.category, table ? "table" : "desk");
        }))
      return found;
  return find([&](const Mention& one) { return keeps_things(one.category, lexicon_.table); });
}

}  // namespace roomgen::brief
