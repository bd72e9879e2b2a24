#include <algorithm>
#include <utility>

#include "mention_shape.h"
#include "settle.h"

namespace roomgen::brief {

namespace {

const Vec3 small_unknown_size(0.2, 0.2, 0.2);

bool is_support(const Demand& demand) {
  return demand.kind == RelationKind::on && demand.mention != Demand::none;
}

void put_on(Mention& mention, std::size_t support) {
  mention.demands.insert(mention.demands.begin(), {RelationKind::on, support, "", false});
}

// A model railway on a large table; whatever finds room on a platform.
bool stands_easily_on(const Mention& mention, const Mention& carrier, const KindTable& table) {
  const bool fits = mention.size.x() < 0.95 * carrier.size.x() && mention.size.y() < 0.95 * carrier.size.y();
  if (table.is_a(carrier.category, "stage platform")) return fits;
  return fits && mention.size.z() <= small_side &&
         !table.is_any_of(mention.category, {"seat", "table", "storage", "bed"});
}

// Is placed otherwise than it was said, and judged as said.
void stand_for(Demand& demand, RelationKind kind) {
  if (!demand.said) demand.said = demand.kind;
  demand.kind = kind;
}

// A lamp on a nightstand is a table lamp, a plant on a desk a small one.
void stand_on_things(Mention& mention, const Brief& brief, const KindTable& table) {
  const auto on = std::find_if(mention.demands.begin(), mention.demands.end(), is_support);
  if (on == mention.demands.end()) return;
  const Mention& carrier = brief.mentions[on->mention];
  const bool lies = table.get(carrier.category).traits.flat;
  // What is on a rug stands on the floor.
  if (lies && mention.mount == Mount::surface) mention.mount = Mount::floor;
  const bool guessed = !mention.known && !table.get(mention.category).is_stand_in();
  if (guessed && !mention.sized) mention.size = small_unknown_size;
  if (mention.mount == Mount::surface) return;
  const bool hangs = mention.mount == Mount::wall &&
                     (mention.sized || std::any_of(mention.demands.begin(), mention.demands.end(),
                                                   [](const Demand& one) {
                                                     return one.kind == RelationKind::above;
                                                   }));
  if (!lies && !hangs && become_small(mention, table)) return;
  if (mention.mount == Mount::wall || mention.mount == Mount::ceiling) {
    on->kind = RelationKind::above;
    return;
  }
  if (lies) return;
  if (mention.size.maxCoeff() <= small_side || stands_easily_on(mention, carrier, table))
    mention.mount = Mount::surface;
  else
    stand_for(*on, RelationKind::near);
}

// "a tray with two cups on the table": the tray is on the table, the cups are on the tray.
void hand_down_supports(Brief& brief) {
  for (auto& mention : brief.mentions) {
    auto& demands = mention.demands;
    const auto listed = std::find_if(demands.begin(), demands.end(), [](const Demand& demand) {
      return is_support(demand) && demand.listed;
    });
    const auto told = std::find_if(demands.begin(), demands.end(), [](const Demand& demand) {
      return is_support(demand) && !demand.listed;
    });
    if (listed == demands.end() || told == demands.end()) continue;
    Mention& tray = brief.mentions[listed->mention];
    if (tray.mount != Mount::surface || &tray == &mention || told->mention == listed->mention)
      continue;
    listed->listed = false;
    if (std::none_of(tray.demands.begin(), tray.demands.end(), is_support))
      tray.demands.insert(tray.demands.begin(), *told);
    demands.erase(told);
  }
}

// What was only heard from a list gives way to what is said of the thing itself.
void drop_listed_supports(Mention& mention, const Brief& brief, const KindTable& table) {
  const bool told =
      std::any_of(mention.demands.begin(), mention.demands.end(),
                  [&](const Demand& demand) { return is_support(demand) && !demand.listed; });
  const auto is_told_of_it = [&](const Demand& listed) {
    return std::any_of(mention.demands.begin(), mention.demands.end(), [&](const Demand& demand) {
      return !demand.listed && demand.mention == listed.mention;
    });
  };
  std::erase_if(mention.demands, [&](const Demand& demand) {
    // "a desk with a chair nearby" has no chair at it.
    const bool is_at_desk = demand.kind == RelationKind::around && demand.mention != Demand::none &&
                            table.is_a(brief.mentions[demand.mention].category, "desk");
    const bool is_loose = is_support(demand) || demand.kind == RelationKind::near || is_at_desk;
    return demand.listed && demand.mention != Demand::none && is_loose && (is_told_of_it(demand) || (told && is_support(demand)));
  });
}

// A shelf above a desk hangs on the wall; a table lamp that lights a sideboard stands on it.
void hang_what_is_above(Mention& mention, const Brief& brief, const KindTable& table) {
  for (auto& demand : mention.demands) {
    if (demand.kind != RelationKind::above || demand.mention == Demand::none) continue;
    const bool small = mention.mount == Mount::surface;
    if (small && table.get(mention.category).forms.wall.empty() &&
        brief.mentions[demand.mention].mount == Mount::floor)
      stand_for(demand, RelationKind::on);
    else if (small || mention.mount == Mount::floor)
      hang(mention, Mount::wall, table);
  }
}

// Wider both ways than what shall carry it, or much longer?
bool is_too_large(const Mention& mention, const Mention& carrier) {
  constexpr double much = 1.5;
  const auto base = mention.size.head<2>(), carrying = carrier.size.head<2>();
  return base.minCoeff() > carrying.minCoeff() || base.maxCoeff() > much * carrying.maxCoeff();
}

// What is beside a thing on a table is on that table too, and the other way round.
bool share_support(Brief& brief, std::size_t a, std::size_t b) {
  for (const auto& [one, other] : {std::pair{a, b}, std::pair{b, a}}) {
    const auto support = support_of(brief.mentions[other]);
    Mention& mention = brief.mentions[one];
    if (!support || *support == one || support_of(mention) || mention.mount != Mount::surface)
      continue;
    put_on(mention, *support);
    return true;
  }
  return false;
}

void share_supports(Brief& brief) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < brief.mentions.size(); ++i) {
      const auto demands = brief.mentions[i].demands;
      for (const auto& demand : demands)
        if (demand.mention != Demand::none &&
            (is_beside(demand.kind) || demand.kind == RelationKind::around))
          changed = share_support(brief, i, demand.mention) || changed;
    }
  }
}

// A fern beside the books on a table is a small one.
void shrink_beside_small(Brief& brief, const KindTable& table) {
  for (auto& mention : brief.mentions) {
    if (mention.mount != Mount::floor) continue;
    for (const auto& demand : mention.demands) {
      if (demand.mention == Demand::none || !is_beside(demand.kind) ||
          brief.mentions[demand.mention].mount != Mount::surface)
        continue;
      become_small(mention, table);
      break;
    }
  }
}

bool stands_beside(const Mention& mention, std::size_t target) {
  return std::any_of(mention.demands.begin(), mention.demands.end(), [&](const Demand& demand) {
    return demand.mention == target && is_beside(demand.kind);
  });
}

// "pots under the benches": on the floor.
void stand_under_things(Mention& mention, const Brief& brief) {
  if (mention.mount != Mount::surface) return;
  const bool is_below = std::any_of(mention.demands.begin(), mention.demands.end(), [&](const Demand& demand) {
    return demand.kind == RelationKind::under && demand.mention != Demand::none && brief.mentions[demand.mention].mount != Mount::surface &&
           brief.mentions[demand.mention].mount != Mount::ceiling;
  });
  if (!is_below) return;
  mention.mount = Mount::floor;
  std::erase_if(mention.demands, [](const Demand& demand) { return is_support(demand) && demand.listed; });
}

bool is_told_beside(const Mention& mention, const Brief& brief) {
  return std::any_of(mention.demands.begin(), mention.demands.end(), [&](const Demand& demand) {
    return demand.mention != Demand::none && !demand.listed && demand.kind == RelationKind::next_to &&
           brief.mentions[demand.mention].mount == Mount::floor;
  });
}

// "a perch next to the desk": what is tall enough to stand beside it on the floor.
void stand_beside_things(Mention& mention, const Brief& brief) {
  constexpr double tall = 0.3;  ///< metres
  if (mention.mount != Mount::surface || support_of(mention) || mention.size.z() < tall) return;
  if (is_told_beside(mention, brief)) mention.mount = Mount::floor;
}

// "by the door", "in the corner"; "down the middle" may be a table's
bool has_place_in_room(const Mention& mention) {
  return std::any_of(mention.demands.begin(), mention.demands.end(), [](const Demand& demand) {
    return demand.mention == Demand::none && demand.kind != RelationKind::on && demand.kind != RelationKind::face_to && demand.kind != RelationKind::middle;
  });
}

// A television has a stand of its own, if no desk is told of.
bool is_no_place_for(const Mention& support, const Mention& mention, const KindTable& table) {
  return table.is_a(mention.category, "tv") && table.is_a(support.category, "desk");
}

// "The table holds a lamp … and a book": small things of which nothing else is said stand where
// others of their sentence do, the nearest in the text.
void support_by_sentence(Brief& brief, const KindTable& table) {
  auto& mentions = brief.mentions;
  for (std::size_t i = 0; i < mentions.size(); ++i) {
    if (mentions[i].mount != Mount::surface || support_of(mentions[i]) || has_place_in_room(mentions[i]) || is_told_beside(mentions[i], brief)) continue;
    std::optional<std::size_t> nearest;
    for (std::size_t j = 0; j < mentions.size(); ++j) {
      const auto support = support_of(mentions[j]);
      if (j == i || mentions[j].sentence != mentions[i].sentence || !support || *support == i ||
          stands_beside(mentions[*support], i) || stands_beside(mentions[i], *support) || is_too_large(mentions[i], mentions[*support]) ||
          is_no_place_for(mentions[*support], mentions[i], table))
        continue;
      const auto distance = [&](std::size_t k) { return k > i ? k - i : i - k; };
      if (!nearest || distance(j) < distance(*nearest)) nearest = j;
    }
    if (nearest) put_on(mentions[i], *support_of(mentions[*nearest]));
  }
}

// "An island under the window, where a cooktop heats a pot": what carries things and was named
// before them in their sentence carries small things of which nothing else is said.
void stand_on_what_was_named(Brief& brief, const KindTable& table) {
  auto& mentions = brief.mentions;
  for (std::size_t i = 0; i < mentions.size(); ++i) {
    if (mentions[i].mount != Mount::surface || !mentions[i].demands.empty() ||
        table.is_any_of(mentions[i].category, {"pillow", "blanket"}))
      continue;
    for (std::size_t j = i; j-- > 0 && mentions[j].sentence == mentions[i].sentence;) {
      const bool is_listed_with_it = mentions[j].list != language::none && mentions[j].list == mentions[i].list;
      if (!keeps_things(mentions[j].category, table) || is_listed_with_it) continue;
      if (mentions[j].mount == Mount::floor && !is_too_large(mentions[i], mentions[j]) && !is_no_place_for(mentions[j], mentions[i], table))
        put_on(mentions[i], j);
      break;
    }
  }
}

}  // namespace

std::optional<std::size_t> support_of(const Mention& mention) {
  const auto on = std::find_if(mention.demands.begin(), mention.demands.end(), is_support);
  return on == mention.demands.end() ? std::nullopt : std::optional(on->mention);
}

bool is_beside(RelationKind kind) {
  return kind == RelationKind::near || kind == RelationKind::next_to ||
         kind == RelationKind::side_of || kind == RelationKind::left_of ||
         kind == RelationKind::right_of || kind == RelationKind::in_front_of ||
         kind == RelationKind::behind;
}

void settle_supports(Brief& brief, const KindTable& table) {
  hand_down_supports(brief);
  for (auto& mention : brief.mentions) drop_listed_supports(mention, brief, table);
  for (auto& mention : brief.mentions) hang_what_is_above(mention, brief, table);
  for (auto& mention : brief.mentions) stand_on_things(mention, brief, table);
  shrink_beside_small(brief, table);
  for (auto& mention : brief.mentions) stand_under_things(mention, brief);
  for (auto& mention : brief.mentions) stand_beside_things(mention, brief);
  share_supports(brief);
  support_by_sentence(brief, table);
  stand_on_what_was_named(brief, table);
  share_supports(brief);
}

}  // namespace roomgen::brief
