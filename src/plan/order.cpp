#include "order.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "floor_plan.h"
#include "roomgen/base/text.h"
#include "scene/room_part.h"

namespace roomgen::plan {

namespace {

constexpr int max_split = 40;
constexpr int tied_stage = 2;

// Furniture waits for furniture; what is to be on top of some comes after it in any case.
bool waits_for(const Draft& draft, const Draft& other) {
  if (draft.item.mount == Mount::floor && other.item.mount == Mount::surface) return false;
  const bool are_kin = draft.part_of != brief::Demand::none && draft.part_of == other.part_of;
  return other.mention != brief::Demand::none &&
         std::any_of(draft.demands.begin(), draft.demands.end(), [&](const brief::Demand& demand) {
           return demand.mention == other.mention ||
                  (!are_kin && demand.mention != brief::Demand::none &&
                   demand.mention == other.part_of);
         });
}

double floor_of(const Draft& draft) {
  return draft.item.size ? draft.item.size->x() * draft.item.size->y() : 0.0;
}

// The stage of its kind; what stands in rows comes before what needs less room; who is told to be in a corner or at a window comes before others take it.
int own_stage(const Draft& draft, const KindTable& table, const Arrangements& arrangements) {
  if (draft.formation && draft.item.mount == Mount::floor) return 0;
  const int usual = arrangements.get(table, draft.item.category, draft.item.mount).stage;
  const bool tied =
      std::any_of(draft.demands.begin(), draft.demands.end(), [](const brief::Demand& demand) {
        return demand.mention == brief::Demand::none && demand.kind != RelationKind::edge &&
               demand.kind != RelationKind::in_part;
      });
  const bool stands =
      draft.item.mount == Mount::floor && !table.get(draft.item.category).traits.flat;
  return tied && stands ? std::min(usual, tied_stage) : usual;
}

// What is told to be at a side of a thing stands there before others take that side.
bool follows(const Draft& draft, const Draft& target, const KindTable& table) {
  const auto stands = [&](const Draft& one) {
    return one.item.mount == Mount::floor && !table.get(one.item.category).traits.flat;
  };
  return draft.item.asked && stands(draft) && stands(target) && waits_for(draft, target);
}

// What others wait for comes as early as they would, and so does what waits for it: a bookshelf before the sofa that is to stand
// in front of it, so that the sofa is still early enough for its coffee table.
std::vector<int> stages_of(const std::vector<Draft>& drafts, const KindTable& table,
                           const Arrangements& arrangements) {
  std::vector<int> stages;
  for (const auto& draft : drafts) stages.push_back(own_stage(draft, table, arrangements));
  // Places at a wall, of those who sit before what hangs there, need floor as blocks do.
  for (std::size_t i = 0; i < drafts.size(); ++i)
    for (const auto& other : drafts)
      if (drafts[i].item.mount == Mount::wall && !drafts[i].item.group.empty() &&
          other.item.group == drafts[i].item.group && other.item.mount == Mount::floor && waits_for(other, drafts[i]))
        stages[i] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < drafts.size(); ++i)
      for (std::size_t j = 0; j < drafts.size(); ++j)
        if (stages[j] > stages[i] &&
            (waits_for(drafts[i], drafts[j]) || follows(drafts[j], drafts[i], table))) {
          stages[j] = stages[i];
          changed = true;
        }
  }
  return stages;
}

void sort_by_stage(std::vector<Draft>& drafts, const KindTable& table,
                   const Arrangements& arrangements) {
  const auto stages = stages_of(drafts, table, arrangements);
  std::vector<std::size_t> order(drafts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (stages[a] != stages[b]) return stages[a] < stages[b];
    if (drafts[a].item.asked != drafts[b].item.asked) return drafts[a].item.asked;
    return floor_of(drafts[a]) > floor_of(drafts[b]) + 1e-9;
  });
  std::vector<Draft> sorted;
  for (std::size_t i : order) sorted.push_back(std::move(drafts[i]));
  drafts = std::move(sorted);
}

void drop_demands(Draft& draft, Plan& plan) {
  plan.notes.push_back("what is asked of the " + draft.item.category +
                       " depends on itself; part of it was left out");
  std::erase_if(draft.demands,
                [](const brief::Demand& demand) { return demand.mention != brief::Demand::none; });
}

// Repeatedly the first draft whose targets are all out.
std::vector<Draft> after_targets(std::vector<Draft> left, Plan& plan) {
  std::vector<Draft> ordered;
  while (!left.empty()) {
    const auto ready = std::find_if(left.begin(), left.end(), [&](const Draft& draft) {
      return std::none_of(left.begin(), left.end(), [&](const Draft& other) {
        return &other != &draft && waits_for(draft, other);
      });
    });
    if (ready == left.end()) {
      drop_demands(left.front(), plan);
      continue;
    }
    ordered.push_back(std::move(*ready));
    left.erase(ready);
  }
  return ordered;
}

// Each thing of an item with several targets becomes an item of its own.
std::vector<Draft> split_pairs(const std::vector<Draft>& drafts) {
  std::map<std::size_t, int> quantity;
  for (const auto& draft : drafts)
    for (const std::size_t mention : {draft.mention, draft.part_of})
      if (mention != brief::Demand::none) quantity[mention] += draft.item.quantity;
  std::vector<Draft> result;
  for (const auto& draft : drafts) {
    const bool pairs =
        std::any_of(draft.demands.begin(), draft.demands.end(), [&](const brief::Demand& demand) {
          return demand.flank ||
                 (demand.mention != brief::Demand::none && quantity[demand.mention] > 1);
        });
    if (!pairs || draft.item.quantity == 1 || draft.item.quantity > max_split) {
      result.push_back(draft);
      continue;
    }
    for (int n = 0; n < draft.item.quantity; ++n) {
      result.push_back(draft);
      result.back().item.quantity = 1;
    }
  }
  return result;
}

/// Gives out the ids of a mention's things in turn.
class Ids {
 public:
  Ids(const std::vector<Draft>& drafts, const Plan& plan) {
    for (const auto& planned : planned_objects(plan)) {
      const Draft& draft = drafts[planned.item];
      ids_[draft.mention].push_back(planned.id);
      if (draft.part_of != brief::Demand::none) parts_[draft.part_of].push_back(planned.id);
    }
    for (const auto& [mention, ids] : ids_) all_[mention] = ids;
    for (const auto& [mention, ids] : parts_) all_[mention].insert(all_[mention].end(), ids.begin(), ids.end());
  }

  // Two neighbours in turn, for what is between them; fewer if there are not two.
  std::vector<std::string> next_two(std::size_t asking, std::size_t mention) {
    const auto& ids = ids_[mention];
    if (ids.size() < 2) return ids;
    const auto turn = static_cast<std::size_t>(turn_[{asking, mention}]++) % (ids.size() - 1);
    return {ids[turn], ids[turn + 1]};
  }

  // One of a mention's things, or of its parts; for its own parts one of those that are left of it.
  std::string next(const Draft& asking, std::size_t mention, int nth) {
    const auto& ids = asking.part_of == mention ? ids_[mention] : all_[mention];
    if (ids.empty()) return "";
    if (nth >= 0) return ids[static_cast<std::size_t>(nth) % ids.size()];
    return ids[static_cast<std::size_t>(turn_[{asking.mention, mention}]++) % ids.size()];
  }

 private:
  std::map<std::size_t, std::vector<std::string>> ids_, parts_, all_;  ///< by mention
  std::map<std::pair<std::size_t, std::size_t>, int> turn_;
};

/// Turns the demands of drafts into relations, one draft after the other.
class Resolver {
 public:
  Resolver(const std::vector<Draft>& drafts, const Plan& plan)
      : ids_(drafts, plan), room_(plan.room) {}

  std::vector<Relation> relations_of(const Draft& draft) {
    std::map<std::size_t, std::string> targets;  // one thing of each mention for all its demands
    std::vector<Relation> relations;
    std::string flanked;
    bool along = false;  ///< at the long sides
    std::size_t sharing = draft.mention;  // which mentions take the sides in turn
    for (const auto& demand : draft.demands) {
      if (demand.part == brief::each_wall) {
        for (const auto& wall : wall_names(room_)) add(relations, {demand.kind, wall, demand.gap});
        continue;
      }
      Relation relation{demand.kind, part_of(room_, demand.part), demand.gap};
      if (demand.kind == RelationKind::between && is_only_between(draft, demand)) {
        for (const auto& id : ids_.next_two(draft.mention, demand.mention))
          add(relations, {RelationKind::between, id});
        continue;
      }
      if (demand.mention != brief::Demand::none) {
        if (!targets.count(demand.mention))
          targets[demand.mention] = ids_.next(draft, demand.mention, demand.nth);
        relation.target = targets[demand.mention];
        if (relation.target.empty()) continue;
      }
      if (demand.flank) {
        sharing = demand.shared ? brief::Demand::none : draft.mention;
        if (demand.kind != RelationKind::around) flanked = relation.target;
        // The long sides of tables are the front and the back.
        along = along || demand.kind == RelationKind::in_front_of;
        if (demand.kind == RelationKind::in_front_of) continue;
      }
      add(relations, relation);
    }
    if (!flanked.empty()) {
      const bool first = sides_[{sharing, flanked}]++ % 2 == 0;
      if (along)
        add(relations, {first ? RelationKind::in_front_of : RelationKind::behind, flanked});
      else
        add(relations, {first ? RelationKind::left_of : RelationKind::right_of, flanked});
    }
    return relations;
  }

 private:
  // "between the beds": said once of several.
  static bool is_only_between(const Draft& draft, const brief::Demand& demand) {
    return demand.mention != brief::Demand::none &&
           std::none_of(draft.demands.begin(), draft.demands.end(),
                        [&](const brief::Demand& other) {
                          return &other != &demand && other.kind == RelationKind::between;
                        });
  }
  static void add(std::vector<Relation>& relations, const Relation& relation) {
    if (std::find(relations.begin(), relations.end(), relation) == relations.end())
      relations.push_back(relation);
  }

  Ids ids_;
  const Room& room_;
  std::map<std::pair<std::size_t, std::string>, int> sides_;
};

}  // namespace

std::vector<Draft> order_items(std::vector<Draft> drafts, const KindTable& table,
                               const Arrangements& arrangements, Plan& plan) {
  sort_by_stage(drafts, table, arrangements);
  drafts = split_pairs(after_targets(std::move(drafts), plan));
  for (const auto& draft : drafts) plan.items.push_back(draft.item);
  Resolver resolver(drafts, plan);
  for (std::size_t i = 0; i < drafts.size(); ++i)
    for (auto& relation : resolver.relations_of(drafts[i])) {
      auto& own = plan.items[i].relations;
      if (std::find(own.begin(), own.end(), relation) == own.end())
        own.push_back(std::move(relation));
    }
  return drafts;
}

}  // namespace roomgen::plan
