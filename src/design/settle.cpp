#include "settle.h"

#include <algorithm>

#include "table_size.h"

namespace roomgen::design {

namespace {

constexpr double small_side = 0.7;  ///< what is smaller may stand on other things
constexpr int seats_at_a_table = 4;
constexpr int usual_few = 2;
const Vec3 unknown_size(0.5, 0.5, 0.8);

void become(Mention& mention, const Category& category) {
  mention.category = category.name;
  mention.known = true;
  mention.mount = category.mount;
  if (!mention.sized) mention.size = category.size;
}

void set_length(Mention& mention, const std::vector<Token>& lengths) {
  if (lengths.empty()) return;
  // One length is the longer side; two are width and depth.
  if (lengths.size() == 1) mention.size.x() = std::clamp(lengths[0].value, 0.05, 10.0);
  for (std::size_t i = 0; lengths.size() > 1 && i < 2; ++i)
    mention.size[static_cast<int>(i)] = std::clamp(lengths[i].value, 0.05, 10.0);
  mention.sized = true;
}

bool is_round(const NounPhrase& phrase) {
  return std::any_of(phrase.modifiers.begin(), phrase.modifiers.end(), [](const std::string& word) {
    return word == "round" || word == "circular" || word == "oval";
  });
}

int usual_number(const Mention& mention, const Brief& brief, const CategoryTable& table) {
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

// A lamp on a nightstand is a table lamp, a plant on a desk a small one.
void stand_on_things(Mention& mention, const Brief& brief, const CategoryTable& table,
                     const KindNames& names) {
  const auto on =
      std::find_if(mention.demands.begin(), mention.demands.end(), [](const Demand& demand) {
        return demand.kind == RelationKind::on && demand.mention != Demand::none;
      });
  if (on == mention.demands.end()) return;
  const Mention& carrier = brief.mentions[on->mention];
  if (mention.mount == Mount::surface) return;
  if (mention.mount == Mount::wall || mention.mount == Mount::ceiling) {
    on->kind = RelationKind::above;
    return;
  }
  const bool lies = table.get(carrier.category).traits.flat;
  for (const char* prefix : {"table ", "small "})
    if (const Category* small = names.find(prefix + mention.category); small && !lies) {
      if (small->mount != Mount::surface) continue;
      become(mention, *small);
      return;
    }
  if (!lies && std::max(mention.size.x(), mention.size.y()) <= small_side)
    mention.mount = Mount::surface;
  else
    on->kind = RelationKind::near;
}

// Furniture on a rug: the rug comes last and lies under it.
void lay_rugs(Brief& brief, const CategoryTable& table) {
  for (std::size_t i = 0; i < brief.mentions.size(); ++i)
    for (auto& demand : brief.mentions[i].demands) {
      if (demand.mention == Demand::none || demand.mention == i) continue;
      Mention& rug = brief.mentions[demand.mention];
      if (!table.get(rug.category).traits.flat || table.get(brief.mentions[i].category).traits.flat)
        continue;
      if (demand.kind != RelationKind::near && demand.kind != RelationKind::on) continue;
      if (rug.demands.empty()) rug.demands.push_back({RelationKind::under, i, "", false});
      demand = {RelationKind::near, Demand::none, "", false};
    }
  for (auto& mention : brief.mentions)
    std::erase_if(mention.demands, [](const Demand& demand) {
      return demand.kind == RelationKind::near && demand.mention == Demand::none &&
             demand.part.empty();
    });
}

bool needs_wall(const Mention& mention, const CategoryTable& table) {
  return table.is_any_of(mention.category, {"storage", "console table", "room divider", "desk"});
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

void turn_behind(Brief& brief, const CategoryTable& table) {
  for (std::size_t i = 0; i < brief.mentions.size(); ++i)
    for (auto& demand : brief.mentions[i].demands) {
      if (demand.kind != RelationKind::behind || demand.mention == Demand::none) continue;
      Mention& other = brief.mentions[demand.mention];
      // A chair "behind" a desk is on its user's side.
      if (table.is_a(brief.mentions[i].category, "seat") &&
          table.is_any_of(other.category, {"table"})) {
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

void note_unknown(Brief& brief) {
  for (const auto& mention : brief.mentions)
    if (!mention.known)
      brief.notes.push_back("\"" + mention.category +
                            "\" is no kind that is known; its size is a guess");
}

}  // namespace

void shape(Mention& mention, const NounPhrase& phrase, const Vocabulary& words,
           const CategoryTable& table, const KindNames& names) {
  const Category* category = table.find(mention.category);
  if (mention.known && category && is_round(phrase))
    if (const Category* round = names.find("round " + mention.category)) category = round;
  if (mention.known && category)
    become(mention, *category);
  else
    mention.size = unknown_size;
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
  set_length(mention, phrase.lengths);
  const auto said = [&](const char* word) {
    return std::find(phrase.modifiers.begin(), phrase.modifiers.end(), word) !=
           phrase.modifiers.end();
  };
  mention.varied = said("different") || said("mismatched") || said("various") || said("assorted");
  if (said("mounted") || said("wall")) hang(mention, Mount::wall, table, names);
}

void hang(Mention& mention, Mount where, const CategoryTable& table, const KindNames& names) {
  if (mention.mount == where) return;
  const std::string prefix = where == Mount::wall ? "wall " : "ceiling ";
  if (const Category* hanging = names.find(prefix + mention.category);
      hanging && hanging->mount == where) {
    become(mention, *hanging);
    return;
  }
  if (mention.mount == Mount::surface ||
      (where == Mount::ceiling && table.is_a(mention.category, "lamp")))
    mention.mount = where;
}

void settle(Brief& brief, const CategoryTable& table, const KindNames& names) {
  for (auto& mention : brief.mentions)
    if (mention.quantity == 0) {
      mention.open = true;
      mention.quantity = usual_number(mention, brief, table);
    }
  for (auto& mention : brief.mentions) stand_on_things(mention, brief, table, names);
  lay_rugs(brief, table);
  turn_behind(brief, table);
  // What is asked for is not forbidden.
  for (const auto& mention : brief.mentions)
    std::erase_if(brief.excluded,
                  [&](const std::string& category) { return mention.category == category; });
  note_unknown(brief);
}

}  // namespace roomgen::design
