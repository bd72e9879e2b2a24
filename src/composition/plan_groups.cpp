#include "plan_groups.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "arrange.h"

namespace roomgen::composition {

namespace {

Result<Composition> composition_of(const PlanGroup& group) {
  const auto& known = built_in_compositions();
  if (!known) return known.error();
  if (group.definition.empty()) {
    const auto found = known->find(group.composition);
    if (found != known->end()) return found->second;
    return Error{Error::Kind::not_found, "there is no composition \"" + group.composition + "\""};
  }
  const auto json = parse_json(group.definition, group.id);
  if (!json) return json.error();
  return read_composition(*json, group.id, "group \"" + group.id + "\"");
}

// What the plan's items say of the things of a group.
Making making_for(const Plan& plan, const PlanGroup& group, const KindTable& kinds,
                  const RealThings& real) {
  Making making{*built_in_compositions(), kinds};
  making.without = group.without;
  making.tuck = real.tuck;
  const auto item_of = [&plan, id = group.id](const std::string& part) -> const PlanItem* {
    for (const auto& item : plan.items)
      if (item.group == id && item.part == part) return &item;
    return nullptr;
  };
  making.kind_of = [item_of](const std::string& part) {
    const PlanItem* item = item_of(part);
    return item ? item->category : std::string();
  };
  making.leans = [item_of](const std::string& part) {
    const PlanItem* item = item_of(part);
    return item && !item->tilt.isZero();
  };
  making.size_of = [item_of,
                    size_of = real.size_of](const std::string& part) -> std::optional<Vec3> {
    if (const auto known = size_of ? size_of(part) : std::nullopt) return known;
    const PlanItem* item = item_of(part);
    return item ? item->size : std::nullopt;
  };
  return making;
}

Result<Arranged> as_asked(const Plan& plan, const PlanGroup& group, const KindTable& kinds) {
  const auto composition = composition_of(group);
  if (!composition) return composition.error();
  return arrange(*composition, group.parameters, making_for(plan, group, kinds, {}));
}

PlanItem item_for(const Member& member, const PlanGroup& group) {
  PlanItem item;
  item.category = member.category;
  item.description = member.description.empty() ? member.category : member.description;
  item.size = member.size;
  item.quantity = 0;
  item.varied = member.varied;
  item.mount = member.mount;
  item.height = member.height;
  item.group = group.id;
  item.part = member.part;
  item.spare = member.spare;
  item.asked = group.asked && member.spare == 0;
  return item;
}

// As many things of a part as the group has: the rest of its items leave it, what is missing is
// added.
void match(Plan& plan, const PlanGroup& group, const Arranged& arranged) {
  std::map<std::string, int> open;
  std::map<std::string, Mount> mounts;
  for (const auto& member : arranged.members) ++open[member.part], mounts[member.part] = member.mount;
  for (std::size_t i = 0; i < plan.items.size(); ++i) {
    if (plan.items[i].group != group.id) continue;
    if (const auto mount = mounts.find(plan.items[i].part); mount != mounts.end())
      plan.items[i].mount = mount->second;
    int& left = open[plan.items[i].part];
    if (plan.items[i].quantity == 0) plan.items[i].quantity = left;  // all that there are
    const int within = std::min(left, plan.items[i].quantity),
              beyond = plan.items[i].quantity - within;
    left -= within;
    if (beyond == 0) continue;
    PlanItem alone = plan.items[i];
    alone.quantity = beyond;
    alone.group.clear(), alone.part.clear();
    plan.items[i].quantity = within;
    if (within == 0)
      plan.items[i] = std::move(alone);
    else
      plan.items.push_back(std::move(alone));
  }
  std::map<std::string, std::size_t> added;
  for (const auto& member : arranged.members) {
    if (open[member.part] <= 0) continue;
    --open[member.part];
    const auto [at, is_new] = added.try_emplace(member.part, plan.items.size());
    if (is_new) plan.items.push_back(item_for(member, group));
    ++plan.items[at->second].quantity;
  }
}

void tell_anchor(Plan& plan, PlanGroup& group, const Arranged& arranged) {
  group.anchor = arranged.members.front().part;
  for (const auto& member : arranged.members)
    group.units[{member.part, member.number}] = member.unit;
  for (auto& item : plan.items) {
    if (item.group != group.id || item.part != arranged.members.front().part) continue;
    for (const auto& relation : group.relations)
      if (std::find(item.relations.begin(), item.relations.end(), relation) == item.relations.end())
        item.relations.push_back(relation);
    if (group.location) item.location = group.location;
    if (group.facing) item.facing = group.facing;
    return;
  }
}

void dissolve(Plan& plan, const std::string& id, const std::string& why) {
  plan.notes.push_back("group \"" + id + "\" was not made: " + why);
  for (auto& item : plan.items) {
    if (item.group != id) continue;
    item.group.clear(), item.part.clear();
    item.quantity = std::max(1, item.quantity);
  }
}

}  // namespace

Result<std::vector<Arranged>> ways_to_stand(const Plan& plan, const PlanGroup& group,
                                            const KindTable& kinds, const RealThings& real) {
  const auto composition = composition_of(group);
  if (!composition) return composition.error();
  auto ways = alternatives(*composition, group.parameters, group.fixed,
                           making_for(plan, group, kinds, real));
  for (const auto& item : plan.items)
    if (ways && item.bottom && item.group == group.id)
      for (auto& way : *ways)
        for (auto& member : way.members)
          if (member.part == item.part && member.mount == Mount::wall)
            member.height = *item.bottom + 0.5 * member.size.z();
  return ways;
}

void complete_groups(Plan& plan, const KindTable& kinds) {
  for (std::size_t g = 0; g < plan.groups.size();) {
    PlanGroup& group = plan.groups[g];
    const auto arranged = as_asked(plan, group, kinds);
    if (!arranged) {
      dissolve(plan, group.id, arranged.error().message);
      plan.groups.erase(plan.groups.begin() + static_cast<std::ptrdiff_t>(g));
      continue;
    }
    match(plan, group, *arranged);
    tell_anchor(plan, group, *arranged);
    ++g;
  }
  for (auto& item : plan.items) {
    if (!item.group.empty() && !find_group(plan, item.group)) item.group.clear(), item.part.clear();
    item.quantity = std::max(1, item.quantity);
  }
}

Plan completed(Plan plan, const KindTable& kinds) {
  complete_groups(plan, kinds);
  return plan;
}

std::vector<PlannedObject> placing_order(const Plan& plan) {
  const auto all = planned_objects(plan);
  const Roles known(plan);
  // What stands on others comes after them, and the anchor before all of its group.
  const auto rank = [&](const PlannedObject& planned) {
    const PlanItem& item = plan.items[planned.item];
    return known.of(planned.id)->is_anchor ? 0 : item.mount == Mount::surface ? 2 : 1;
  };
  std::vector<PlannedObject> order;
  std::set<std::string> begun;
  for (const auto& planned : all) {
    const Role* role = known.of(planned.id);
    if (!role) order.push_back(planned);
    if (!role || !begun.insert(role->group).second) continue;
    std::vector<PlannedObject> group;
    for (const auto& other : all)
      if (const Role* its = known.of(other.id); its && its->group == role->group)
        group.push_back(other);
    std::stable_sort(group.begin(), group.end(),
                     [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    order.insert(order.end(), group.begin(), group.end());
  }
  postpone(plan, order, [&](const PlannedObject& planned) {
    const Role* role = known.of(planned.id);
    return !plan.items[planned.item].location && (!role || role->is_anchor);
  });
  // Many things that somebody asked for to stand together go before single ones that nobody did: those find
  // room beside them.
  constexpr int many = 12;
  std::map<std::string, int> things;
  for (const auto& planned : all)
    if (const Role* role = known.of(planned.id)) ++things[role->group];
  const bool has_block = std::any_of(plan.groups.begin(), plan.groups.end(), [&](const PlanGroup& group) {
    return group.asked && things[group.id] >= many;
  });
  if (has_block)
    postpone(plan, order, [&](const PlannedObject& planned) {
      const PlanItem& item = plan.items[planned.item];
      return item.group.empty() && !item.asked && !item.location && item.mount == Mount::floor;
    });
  // What dresses the room comes last; in a group it has its place.
  const auto spare = [&](const PlannedObject& planned) {
    const PlanItem& item = plan.items[planned.item];
    return item.group.empty() && item.spare > 0 ? item.spare : std::numeric_limits<int>::max();
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](const auto& a, const auto& b) { return spare(a) > spare(b); });
  return order;
}

void postpone(const Plan& plan, std::span<PlannedObject> order,
              const std::function<bool(const PlannedObject&)>& is_late) {
  const Roles known(plan);
  std::set<std::string> late_things, late_groups;
  const auto waits = [&](const PlannedObject& planned) {
    const PlanItem& item = plan.items[planned.item];
    const Role* role = known.of(planned.id);
    if (role && !role->is_anchor) return late_groups.count(role->group) > 0;
    // Whatever might carry it comes first.
    return (item.mount == Mount::surface && !late_things.empty()) ||
           std::any_of(item.relations.begin(), item.relations.end(), [&](const Relation& relation) {
             return late_things.count(relation.target) > 0;
           });
  };
  std::vector<PlannedObject> late;
  auto kept = order.begin();
  for (auto& planned : order) {
    if (!is_late(planned) && !waits(planned)) {
      std::swap(*kept++, planned);
      continue;
    }
    late_things.insert(planned.id);
    if (const Role* role = known.of(planned.id); role && role->is_anchor)
      late_groups.insert(role->group);
    late.push_back(planned);
  }
  std::move(late.begin(), late.end(), kept);
}

const PlanGroup* find_group(const Plan& plan, const std::string& id) {
  for (const auto& group : plan.groups)
    if (group.id == id) return &group;
  return nullptr;
}

Roles::Roles(const Plan& plan) {
  std::map<std::pair<std::string, std::string>, std::size_t> numbers;
  for (const auto& planned : planned_objects(plan)) {
    const PlanItem& item = plan.items[planned.item];
    if (item.group.empty()) continue;
    Role role{item.group, item.part, numbers[{item.group, item.part}]++};
    if (const PlanGroup* group = find_group(plan, role.group)) {
      role.is_anchor = role.number == 0 && role.part == group->anchor;
      if (const auto unit = group->units.find({role.part, role.number}); unit != group->units.end())
        role.unit = unit->second;
    }
    ids_[{role.group, role.part, role.number}] = planned.id;
    by_id_[planned.id] = std::move(role);
  }
}

const Role* Roles::of(const std::string& id) const {
  const auto found = by_id_.find(id);
  return found == by_id_.end() ? nullptr : &found->second;
}

std::string Roles::id_of(const std::string& group, const Member& member) const {
  const auto found = ids_.find({group, member.part, member.number});
  return found == ids_.end() ? std::string() : found->second;
}

std::map<std::string, std::string> carriers(const Plan& plan, const KindTable& kinds) {
  const Roles known(plan);
  std::map<std::string, std::string> found;
  for (const auto& group : plan.groups) {
    const auto arranged = as_asked(plan, group, kinds);
    if (!arranged) continue;
    for (const auto& member : arranged->members)
      if (member.mount == Mount::surface)
        found[known.id_of(group.id, member)] =
            known.id_of(group.id, arranged->members[member.on]);
  }
  return found;
}

}  // namespace roomgen::composition
