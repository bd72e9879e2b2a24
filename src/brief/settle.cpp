#include "settle.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "table_size.h"

namespace roomgen::design {

bool needs_wall(const Mention& mention, const KindTable& table) {
  return table.is_any_of(mention.category, {"storage", "console table", "room divider", "desk"});
}

namespace {

constexpr int seats_at_a_table = 4;
constexpr int usual_few = 2;
constexpr double between_loads = 0.05;  ///< metres between things on a table
constexpr double fullest_top = 0.55;    ///< share of a top that things take
constexpr double widest = 1.35, widest_if_sized = 1.1;
const Vec3 unknown_size(0.5, 0.5, 0.8);
const Vec3 small_unknown_size(0.2, 0.2, 0.2);

void become(Mention& mention, const Kind& category) {
  mention.category = category.name;
  mention.known = true;
  mention.mount = category.mount;
  if (!mention.sized) mention.size = category.size;
}

// What nobody knows is as large as such things are.
void guess_size(Mention& mention, const KindTable& table) {
  const Kind& like = table.get(mention.category);
  mention.size = like.is_stand_in() ? like.size : unknown_size;
  if (like.is_stand_in()) mention.mount = like.mount;
}

// Metres that a thing may be told to be long.
double told(double length) {
  return std::clamp(length, 0.05, 10.0);
}

// Width and depth, and perhaps height.
void set_sides(Mention& mention, const language::Measure& measure) {
  static constexpr const char* names[] = {"width", "depth", "height"};
  mention.lengths.clear();
  for (int i = 0; i < measure.count; ++i) {
    mention.size[i] = told(measure.values[i]);
    mention.lengths.push_back({names[i], mention.size[i]});
  }
}

// One length is the longer side, two are width and depth, unless it is said which.
void set_length(Mention& mention, const language::Measure& measure) {
  using Measure = language::Measure;
  if (measure.kind == Measure::Kind::area || measure.side == Measure::Side::distance) return;
  switch (measure.side) {
    case Measure::Side::height:
    case Measure::Side::thickness:
      mention.size.z() = told(measure.values[0]);
      mention.lengths.push_back({"height", mention.size.z()});
      break;
    case Measure::Side::depth:
      mention.size.y() = told(measure.values[0]);
      mention.lengths.push_back({"depth", mention.size.y()});
      break;
    case Measure::Side::diameter:
      mention.size.x() = mention.size.y() = told(measure.values[0]);
      mention.lengths.push_back({"diameter", mention.size.x()});
      break;
    default:
      mention.size.x() = told(measure.values[0]);
      mention.lengths.push_back({measure.side == Measure::Side::width ? "width" : "longer side",
                                 mention.size.x()});
  }
  if (measure.kind == Measure::Kind::sides) set_sides(mention, measure);
  mention.sized = true;
}

bool is_round(const ThingPhrase& phrase) {
  return std::any_of(phrase.modifiers.begin(), phrase.modifiers.end(), [](const std::string& word) {
    return word == "round" || word == "circular" || word == "oval";
  });
}

int usual_number(const Mention& mention, const Brief& brief, const KindTable& table) {
  // How many windows there will be is not known yet.
  if (table.get(mention.category).covers_window) return 1;
  const bool seat = table.is_any_of(mention.category, {"chair", "stool"});
  if (seat && brief.people > 0) return brief.people;
  const bool table_there =
      std::any_of(brief.mentions.begin(), brief.mentions.end(), [&](const Mention& m) {
        return table.is_any_of(m.category, {"dining table", "kitchen island"}) ||
               m.category == "table";
      });
  return seat && table_there ? seats_at_a_table : usual_few;
}

// Makes it what stands on tables: a table lamp, a small plant; a fern stays a fern, as small as
// small plants are. False if there is no such kind.
bool become_small(Mention& mention, const KindTable& table) {
  const Kind* kind = table.find(mention.category);
  for (int i = 0; kind && i < 4; ++i) {
    if (const Kind* small = table.by_name(kind->forms.small)) {
      if (i == 0) {
        become(mention, *small);
      } else {
        mention.mount = Mount::surface;
        mention.size *= std::min(1.0, (small->size.array() / mention.size.array()).minCoeff());
        mention.sized = true;
      }
      return true;
    }
    kind = kind->parent.empty() ? nullptr : table.find(kind->parent);
  }
  return false;
}

bool is_support(const Demand& demand) {
  return demand.kind == RelationKind::on && demand.mention != Demand::none;
}

std::optional<std::size_t> support_of(const Mention& mention) {
  const auto on = std::find_if(mention.demands.begin(), mention.demands.end(), is_support);
  return on == mention.demands.end() ? std::nullopt : std::optional(on->mention);
}

void put_on(Mention& mention, std::size_t support) {
  mention.demands.insert(mention.demands.begin(), {RelationKind::on, support, "", false});
}

// A model railway on a large table.
bool stands_easily_on(const Mention& mention, const Mention& carrier, const KindTable& table) {
  return mention.size.x() < 0.95 * carrier.size.x() && mention.size.y() < 0.95 * carrier.size.y() &&
         mention.size.z() <= small_side &&
         !table.is_any_of(mention.category, {"seat", "table", "storage", "bed"});
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
    on->kind = RelationKind::near;
}

bool is_beside(RelationKind kind) {
  return kind == RelationKind::near || kind == RelationKind::next_to ||
         kind == RelationKind::side_of || kind == RelationKind::left_of ||
         kind == RelationKind::right_of || kind == RelationKind::in_front_of ||
         kind == RelationKind::behind;
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
void drop_listed_supports(Mention& mention) {
  const bool told =
      std::any_of(mention.demands.begin(), mention.demands.end(),
                  [&](const Demand& demand) { return is_support(demand) && !demand.listed; });
  const auto is_beside_it = [&](const Demand& support) {
    return std::any_of(mention.demands.begin(), mention.demands.end(), [&](const Demand& demand) {
      return demand.mention == support.mention && is_beside(demand.kind);
    });
  };
  std::erase_if(mention.demands, [&](const Demand& demand) {
    return is_support(demand) && demand.listed && (told || is_beside_it(demand));
  });
}

// A shelf above a desk hangs on the wall; a table lamp that lights a sideboard stands on it.
void hang_what_is_above(Mention& mention, const Brief& brief, const KindTable& table) {
  for (auto& demand : mention.demands) {
    if (demand.kind != RelationKind::above || demand.mention == Demand::none) continue;
    const bool small = mention.mount == Mount::surface;
    if (small && table.get(mention.category).forms.wall.empty() &&
        brief.mentions[demand.mention].mount == Mount::floor)
      demand.kind = RelationKind::on;
    else if (small || mention.mount == Mount::floor)
      hang(mention, Mount::wall, table);
  }
}

// Wider both ways than what shall carry it?
bool is_too_large(const Mention& mention, const Mention& carrier) {
  return mention.size.head<2>().minCoeff() > carrier.size.head<2>().minCoeff();
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

// "The table holds a lamp … and a book": small things of which nothing else is said stand where
// others of their sentence do, the nearest in the text.
void support_by_sentence(Brief& brief) {
  auto& mentions = brief.mentions;
  for (std::size_t i = 0; i < mentions.size(); ++i) {
    if (mentions[i].mount != Mount::surface || support_of(mentions[i])) continue;
    std::optional<std::size_t> nearest;
    for (std::size_t j = 0; j < mentions.size(); ++j) {
      const auto support = support_of(mentions[j]);
      if (j == i || mentions[j].sentence != mentions[i].sentence || !support || *support == i ||
          stands_beside(mentions[*support], i) || is_too_large(mentions[i], mentions[*support]))
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
      if (!keeps_things(mentions[j].category, table)) continue;
      if (mentions[j].mount == Mount::floor && !is_too_large(mentions[i], mentions[j]))
        put_on(mentions[i], j);
      break;
    }
  }
}

// A stool beside the lamp on a table is beside the table.
void stand_beside_carriers(Brief& brief) {
  for (std::size_t i = 0; i < brief.mentions.size(); ++i) {
    Mention& mention = brief.mentions[i];
    if (mention.mount != Mount::floor) continue;
    for (auto& demand : mention.demands) {
      if (demand.mention == Demand::none || !is_beside(demand.kind)) continue;
      const Mention& target = brief.mentions[demand.mention];
      const auto carrier = target.mount == Mount::surface ? support_of(target) : std::nullopt;
      if (carrier && *carrier != i) demand.mention = *carrier;
    }
  }
}

// Only what is on a thing can be inside it.
void keep_inside_what_carries(Mention& mention) {
  const auto support = support_of(mention);
  std::erase_if(mention.demands, [&](const Demand& demand) {
    return demand.kind == RelationKind::inside &&
           (mention.mount != Mount::surface || support != demand.mention);
  });
}

// Whose one top is what carries things.
bool has_one_top(const Mention& mention, const KindTable& table) {
  return table.is_any_of(mention.category,
                         {"table", "nightstand", "bar cart", "tray", "kitchen island"}) &&
         !table.get(mention.category).traits.flat;
}

// A table for many things is a larger one.
void widen_for_loads(Brief& brief, const KindTable& table) {
  std::vector<double> loads(brief.mentions.size(), 0.0);
  for (const auto& mention : brief.mentions)
    if (const auto support = support_of(mention); support && mention.mount == Mount::surface)
      loads[*support] +=
          mention.quantity * (mention.size.head<2>() + Vec2::Constant(between_loads)).prod();
  for (std::size_t i = 0; i < brief.mentions.size(); ++i) {
    Mention& carrier = brief.mentions[i];
    if (loads[i] == 0.0 || !has_one_top(carrier, table)) continue;
    const double need = loads[i] / carrier.quantity / fullest_top;
    const double factor = std::sqrt(need / carrier.size.head<2>().prod());
    carrier.size.head<2>() *= std::clamp(factor, 1.0, carrier.sized ? widest_if_sized : widest);
  }
}

// "A television on a stand across from the sofa": where the stand stands.
bool places_on_floor(const Demand& demand, const Brief& brief, std::size_t carrier) {
  if (demand.kind == RelationKind::on || demand.kind == RelationKind::inside ||
      demand.kind == RelationKind::above || demand.kind == RelationKind::under)
    return false;
  if (demand.mention == Demand::none)
    return !demand.part.empty() || demand.kind == RelationKind::edge ||
           demand.kind == RelationKind::corner;
  return demand.mention != carrier && brief.mentions[demand.mention].mount == Mount::floor;
}

void lift_to_carriers(Brief& brief) {
  for (auto& mention : brief.mentions) {
    const auto support = support_of(mention);
    if (mention.mount != Mount::surface || !support) continue;
    Mention& carrier = brief.mentions[*support];
    if (carrier.mount != Mount::floor) continue;
    const auto lifted = std::stable_partition(
        mention.demands.begin(), mention.demands.end(),
        [&](const Demand& demand) { return !places_on_floor(demand, brief, *support); });
    // Its own place, where it has one, is what counts.
    if (carrier.demands.empty()) carrier.demands.assign(lifted, mention.demands.end());
    mention.demands.erase(lifted, mention.demands.end());
  }
}

// Two at one table, or two things on it, are opposite each other without being far apart.
void calm_opposites(Brief& brief, const KindTable& table) {
  const auto small_or_seat = [&](const Mention& mention) {
    return mention.mount == Mount::surface || table.is_any_of(mention.category, {"chair", "stool"});
  };
  for (auto& mention : brief.mentions)
    std::erase_if(mention.demands, [&](const Demand& demand) {
      return demand.kind == RelationKind::far && demand.mention != Demand::none &&
             small_or_seat(mention) && small_or_seat(brief.mentions[demand.mention]);
    });
}

// Furniture on a rug whose place is told stands over it; else the rug comes last and lies under it.
void lay_rugs(Brief& brief, const KindTable& table) {
  for (std::size_t i = 0; i < brief.mentions.size(); ++i)
    for (auto& demand : brief.mentions[i].demands) {
      if (demand.mention == Demand::none || demand.mention == i) continue;
      Mention& rug = brief.mentions[demand.mention];
      if (!table.get(rug.category).traits.flat || table.get(brief.mentions[i].category).traits.flat)
        continue;
      const bool beside = demand.kind == RelationKind::near || demand.kind == RelationKind::next_to;
      if (!beside && demand.kind != RelationKind::on) continue;
      const bool small = brief.mentions[i].size.maxCoeff() <= small_side;
      if (demand.kind == RelationKind::on && (small || !rug.demands.empty())) continue;
      if (rug.demands.empty()) rug.demands.push_back({RelationKind::under, i, "", false});
      demand = {RelationKind::near, Demand::none, "", false};
    }
  for (auto& mention : brief.mentions)
    std::erase_if(mention.demands, [](const Demand& demand) {
      return demand.kind == RelationKind::near && demand.mention == Demand::none &&
             demand.part.empty();
    });
}

bool stands_at_wall(const Mention& mention) {
  return std::any_of(mention.demands.begin(), mention.demands.end(), [](const Demand& demand) {
    return demand.kind == RelationKind::edge || demand.kind == RelationKind::corner;
  });
}

bool faces_something(const Mention& mention) {
  return std::any_of(mention.demands.begin(), mention.demands.end(), [](const Demand& demand) {
    return demand.kind == RelationKind::face_to || demand.kind == RelationKind::face_same_as;
  });
}

// A chair in front of a desk is drawn up to it.
void draw_up_seats(Brief& brief, const KindTable& table) {
  for (auto& mention : brief.mentions) {
    if (!table.is_any_of(mention.category, {"chair", "stool"})) continue;
    const auto before =
        std::find_if(mention.demands.begin(), mention.demands.end(), [&](const Demand& demand) {
          return demand.kind == RelationKind::in_front_of && demand.mention != Demand::none &&
                 table.is_a(brief.mentions[demand.mention].category, "table");
        });
    if (before == mention.demands.end() || faces_something(mention)) continue;
    Demand around = *before;
    around.kind = RelationKind::around;
    mention.demands.push_back(around);
  }
}

void turn_behind(Brief& brief, const KindTable& table) {
  for (std::size_t i = 0; i < brief.mentions.size(); ++i)
    for (auto& demand : brief.mentions[i].demands) {
      if (demand.kind != RelationKind::behind || demand.mention == Demand::none) continue;
      Mention& other = brief.mentions[demand.mention];
      // A chair "behind" a desk is on its user's side.
      if (table.is_a(brief.mentions[i].category, "seat") && table.is_a(other.category, "table")) {
        demand.kind = RelationKind::around;
        continue;
      }
      if (!needs_wall(brief.mentions[i], table) || stands_at_wall(other)) continue;
      other.demands.push_back({RelationKind::in_front_of, i, "", false});
      if (!faces_something(other))
        other.demands.push_back({RelationKind::face_same_as, i, "", false});
      demand = {RelationKind::edge, Demand::none, "", false};
    }
}

// "exactly two chairs and exactly three chairs": the first number is built, the other one stays a
// requirement that is not met.
void find_contradictions(Brief& brief) {
  for (std::size_t i = 0; i < brief.mentions.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      Mention& later = brief.mentions[i];
      const Mention& first = brief.mentions[j];
      const bool same = later.category == first.category &&
                        later.description == first.description && later.demands.empty() &&
                        first.demands.empty();
      if (!same || !later.counted || !first.counted || later.quantity == first.quantity) continue;
      later.contradicts = true;
      brief.notes.push_back("the prompt asks for " + std::to_string(first.quantity) + " and for " +
                            std::to_string(later.quantity) + " of \"" + later.description +
                            "\": the first number counts");
      break;
    }
}

void note_unknown(Brief& brief) {
  for (const auto& mention : brief.mentions)
    if (!mention.known)
      brief.notes.push_back("\"" + mention.category +
                            "\" is no kind that is known; its size is a guess");
}

}  // namespace

void shape(Mention& mention, const ThingPhrase& phrase, const Vocabulary& words,
           const KindTable& table) {
  const Kind* category = table.find(mention.category);
  if (mention.known && category && is_round(phrase))
    if (const Kind* round = table.by_name(category->forms.round)) category = round;
  if (mention.known && category)
    become(mention, *category);
  else
    guess_size(mention, table);
  if (mention.known && is_round(phrase) && !table.get(mention.category).traits.round &&
      table.is_a(mention.category, "table"))
    mention.size.y() = mention.size.x() = std::max(0.5, 0.8 * mention.size.x());
  for (const auto& word : phrase.modifiers)
    if (const auto size = words.sizes.find(word); size != words.sizes.end()) {
      mention.size = mention.size.cwiseProduct(size->second);
      mention.sized = true;
    }
  if (phrase.seats > 0 && table.is_a(mention.category, "dining table")) {
    mention.size = table_for(mention.size, table.get(mention.category).traits.round, phrase.seats);
    mention.sized = true;
  }
  for (const auto& measure : phrase.measures) set_length(mention, measure);
  const auto said = [&](const char* word) {
    return std::find(phrase.modifiers.begin(), phrase.modifiers.end(), word) !=
           phrase.modifiers.end();
  };
  mention.varied = said("different") || said("mismatched") || said("various") || said("assorted");
  if (said("ceiling"))
    hang(mention, Mount::ceiling, table);
  else if (said("mounted") || said("wall"))
    hang(mention, Mount::wall, table);
}

void hang(Mention& mention, Mount where, const KindTable& table) {
  if (mention.mount == where) return;
  if (where == Mount::floor) {
    if (mention.mount == Mount::surface) mention.mount = where;
    return;
  }
  const Forms& forms = table.get(mention.category).forms;
  if (const Kind* hanging = table.by_name(where == Mount::wall ? forms.wall : forms.ceiling))
    return become(mention, *hanging);
  if (mention.mount == Mount::surface || where == Mount::ceiling) mention.mount = where;
}

bool keeps_things(const std::string& category, const KindTable& table) {
  return table.is_any_of(category,
                         {"table", "storage", "kitchen unit", "kitchen island", "washbasin"});
}

// Between two things, or two of a kind; of one only what stands beside it is left.
void settle_between(Mention& mention, const Brief& brief) {
  const auto is_between = [](const Demand& demand) { return demand.kind == RelationKind::between; };
  auto& demands = mention.demands;
  // "between the sofa and the window" means one window, "between the windows" two.
  if (std::count_if(demands.begin(), demands.end(), is_between) > 2)
    std::erase_if(demands, [&](const Demand& demand) {
      return is_between(demand) && demand.part == "window-1";
    });
  if (std::count_if(demands.begin(), demands.end(), is_between) != 1) return;
  const auto only = std::find_if(demands.begin(), demands.end(), is_between);
  if (only->mention == Demand::none)
    only->kind = RelationKind::near;
  else if (brief.mentions[only->mention].quantity < 2)
    only->kind = RelationKind::next_to;
}

void settle(Brief& brief, const KindTable& table) {
  for (auto& mention : brief.mentions)
    if (mention.quantity == 0) {
      mention.open = true;
      mention.quantity = usual_number(mention, brief, table);
    }
  for (auto& mention : brief.mentions) settle_between(mention, brief);
  hand_down_supports(brief);
  for (auto& mention : brief.mentions) drop_listed_supports(mention);
  for (auto& mention : brief.mentions) hang_what_is_above(mention, brief, table);
  for (auto& mention : brief.mentions) stand_on_things(mention, brief, table);
  shrink_beside_small(brief, table);
  share_supports(brief);
  support_by_sentence(brief);
  stand_on_what_was_named(brief, table);
  share_supports(brief);
  widen_for_loads(brief, table);
  stand_beside_carriers(brief);
  lift_to_carriers(brief);
  for (auto& mention : brief.mentions) keep_inside_what_carries(mention);
  calm_opposites(brief, table);
  lay_rugs(brief, table);
  draw_up_seats(brief, table);
  turn_behind(brief, table);
  find_contradictions(brief);
  // What is asked for is not forbidden.
  for (const auto& mention : brief.mentions)
    std::erase_if(brief.excluded,
                  [&](const std::string& category) { return mention.category == category; });
  note_unknown(brief);
}

}  // namespace roomgen::design
