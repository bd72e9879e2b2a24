#include "settle.h"

#include <algorithm>

#include "mention_shape.h"
#include "scene/resolved_relation.h"

namespace roomgen::brief {

namespace {

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

// Two at one table, two things on it, or a seat and its table are opposite each other without being far apart.
void calm_opposites(Brief& brief, const KindTable& table) {
  const auto small_or_seat = [&](const Mention& mention) {
    return mention.mount == Mount::surface || table.is_any_of(mention.category, {"chair", "stool"});
  };
  for (auto& mention : brief.mentions)
    std::erase_if(mention.demands, [&](const Demand& demand) {
      return demand.kind == RelationKind::far && demand.mention != Demand::none &&
             small_or_seat(mention) &&
             (small_or_seat(brief.mentions[demand.mention]) || table.is_a(brief.mentions[demand.mention].category, "table"));
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
      if (rug.demands.empty()) {
        rug.demands.push_back({RelationKind::under, i, "", false});
        rug.demands.back().heard = demand.heard;
      }
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

// Serves what is said of another thing.
Demand means(RelationKind kind, std::size_t target) {
  Demand demand{kind, target, "", false};
  demand.is_means = true;
  return demand;
}

constexpr int most_before_a_desk = 2;

// Who sits at a desk does so on its user's side; more than fit there are on all its sides.
void sit_before_desks(Brief& brief, const KindTable& table) {
  for (auto& mention : brief.mentions) {
    if (!table.is_any_of(mention.category, {"chair", "stool"})) continue;
    const auto at_desk = std::find_if(mention.demands.begin(), mention.demands.end(), [&](const Demand& demand) {
      return demand.kind == RelationKind::around && demand.mention != Demand::none &&
             table.is_a(brief.mentions[demand.mention].category, "desk");
    });
    if (at_desk == mention.demands.end()) continue;
    const std::size_t desk = at_desk->mention;
    const bool is_placed = std::any_of(mention.demands.begin(), mention.demands.end(), [&](const Demand& demand) {
      return demand.mention == desk && demand.kind != RelationKind::around;
    });
    const bool fit_before_it = mention.quantity <= most_before_a_desk * std::max(1, brief.mentions[desk].quantity);
    if (!is_placed && fit_before_it) mention.demands.push_back(means(RelationKind::in_front_of, desk));
  }
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

// "two desks back to back": both stand free.
bool turns_its_back(const Mention& mention, std::size_t to) {
  return std::any_of(mention.demands.begin(), mention.demands.end(), [&](const Demand& demand) {
    return demand.kind == RelationKind::face_opposite_to && demand.mention == to;
  });
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
      if (!needs_wall(brief.mentions[i], table) || stands_at_wall(other) || turns_its_back(brief.mentions[i], demand.mention)) continue;
      // What was said stays what is checked.
      const Demand said = demand;
      other.demands.push_back(means(RelationKind::in_front_of, i));
      if (!faces_something(other))
        other.demands.push_back(means(RelationKind::face_same_as, i));
      demand = {RelationKind::edge, Demand::none, "", false};
      demand.heard = said.heard, demand.said = RelationKind::behind, demand.said_of = said.mention;
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

// "A desk facing the door": who sits at it looks there.
void say_facing_by_use(Brief& brief, const KindTable& table) {
  const auto by_use = [&](const std::string& category, RelationKind kind) {
    return kind == RelationKind::face_to ? facing_of_use(table.get(category)) : kind;
  };
  for (auto& mention : brief.mentions)
    for (auto& demand : mention.demands) {
      demand.kind = by_use(mention.category, demand.kind);
      if (demand.said) demand.said = by_use(mention.category, *demand.said);
    }
  for (auto& denial : brief.denials)
    denial.kind = by_use(brief.mentions[denial.thing].category, denial.kind);
}

}  // namespace

void settle(Brief& brief, const KindTable& table) {
  settle_numbers(brief, table);
  for (auto& mention : brief.mentions) settle_between(mention, brief);
  settle_supports(brief, table);
  settle_numbers_on_carriers(brief);
  settle_carriers(brief, table);
  calm_opposites(brief, table);
  lay_rugs(brief, table);
  draw_up_seats(brief, table);
  turn_behind(brief, table);
  sit_before_desks(brief, table);
  find_contradictions(brief);
  // What is asked for is not forbidden.
  for (const auto& mention : brief.mentions)
    std::erase_if(brief.excluded,
                  [&](const std::string& category) { return mention.category == category; });
  note_unknown(brief);
  say_facing_by_use(brief, table);
}

}  // namespace roomgen::brief
