#include "dry_run.h"

#include <algorithm>
#include <map>
#include <set>

#include "composition/plan_groups.h"
#include "place_group.h"
#include "scene/judgement.h"
#include "support.h"

namespace roomgen {

namespace {

constexpr double size_margin = 1.05;
constexpr double loose_gap = 0.1;  ///< metres beyond what the pair prefers
// Of what usually stands and is to hang on a wall.
constexpr double usual_elevation = 1.2;
// A box that passes the cheap tests nearly always passes the others.
constexpr int most_exact_tests = 60;
// Of a group: whether the room is large enough is seen before the smallest ones.
constexpr std::size_t most_ways = 16;

// Near in name only: who asks for "next to" wants no gap to walk through.
bool is_loose(const ResolvedRelation& relation, const Footprint& own) {
  return relation.kind == RelationKind::near &&
         std::none_of(relation.targets.begin(), relation.targets.end(),
                      [&](const Footprint& target) {
                        return gap(own, target) <= relation.gap_high + loose_gap;
                      });
}

int count_broken(const Layout& layout, Object object, const PlanItem& item) {
  if (item.relations.empty()) return 0;
  object.relations = item.relations;
  const Subject subject{footprint(object), bottom(object), top(object)};
  int broken = 0;
  for (const auto& relation :
       resolve(object, layout.room(), layout.objects(), layout.categories())) {
    broken += judge(relation, subject, layout.room()).held ? 0 : 1;
    broken += object.mount == Mount::floor && is_loose(relation, subject.footprint) ? 1 : 0;
  }
  return broken;
}

PlacementTask task_for(const Plan& plan, const PlannedObject& planned, const Layout& layout) {
  const PlanItem& item = plan.items[planned.item];
  const Kind& category = layout.categories().get(item.category);
  PlacementTask task;
  Object& object = task.object;
  object.id = planned.id;
  object.category = item.category;
  object.traits = category.traits;
  object.size = item.size.value_or(category.size);
  if (category.foot > 0.0) object.size.head<2>().setConstant(category.foot);
  // Real ones may be a little larger. In a group each has its place beside the others.
  if (item.asked && item.mount == Mount::floor && item.group.empty()) object.size.head<2>() *= size_margin;
  object.mount = item.mount;
  object.position.z() =
      mounting_height(item.mount, object.size.z(),
                      category.mount == Mount::wall ? category.elevation : usual_elevation,
                      layout.room());
  object.relations = known_relations(item.relations, layout.room(), layout.objects());
  task.location = item.location;
  task.facing = item.facing;
  task.binding = item.location.has_value();
  task.asked = item.asked;
  task.wishes = item.asked ? static_cast<int>(object.relations.size()) : 0;
  task.usual = true;
  task.anywhere = item.asked;
  task.of_its_kind = quantity_of(plan, item.category);
  return task;
}

// Of a small thing it is enough to know that boxes leave it room.
std::optional<Object> place_as_box(Layout& layout, const PlanItem& item, PlacementTask task) {
  if (item.mount == Mount::surface)
    if (const auto spot = choose_support(layout, item.on, 0, task))
      return at_pose(task.object, *spot);
  PlaceOptions options;
  options.max_exact_tests = most_exact_tests;
  Random random(0);
  auto placed = place(layout, task, {}, options, random);
  if (!placed) return std::nullopt;
  return std::move(placed->object);
}

/// Places what is planned, one thing or group after the other.
class DryRunning {
 public:
  DryRunning(const Plan& plan, const KindTable& kinds, const Arrangements& arrangements)
      : plan_(plan), roles_(plan), layout_(plan.room, kinds, boxes_, &arrangements) {
    for (const auto& planned : planned_objects(plan)) planned_.emplace(planned.id, planned);
  }

  DryRun run(const std::function<bool(const DryRun&)>& is_hopeless) {
    for (const auto& planned : composition::placing_order(plan_)) {
      const PlanItem& item = plan_.items[planned.item];
      if (layout_.categories().get(item.category).covers_window) continue;  // it hangs where the windows are
      if (places_.count(planned.id) > 0 && !places_.at(planned.id)) {
        result_.missed.push_back(planned);
        continue;
      }
      const auto placed = placed_as_box(planned, item);
      const int broken = placed ? count_broken(layout_, *placed, item) : 0;
      result_.broken += broken;
      if (placed) layout_.add(*placed);
      else result_.missed.push_back(planned);
      if ((broken > 0 || !placed) && is_hopeless && is_hopeless(result_)) break;
    }
    return std::move(result_);
  }

 private:
  std::optional<Object> placed_as_box(const PlannedObject& planned, const PlanItem& item) {
    if (const auto known = places_.find(planned.id); known != places_.end()) return known->second;
    PlacementTask task = task_for(plan_, planned, layout_);
    const composition::Role* role = roles_.of(planned.id);
    if (const auto unit = units_.find(planned.id); unit != units_.end()) {
      if (auto placed = place_ways({&unit->second, 1}, role->group, task)) return placed;
    } else if (role && tried_.insert(role->group).second && item.mount != Mount::surface) {
      if (auto placed = place_whole(*composition::find_group(plan_, role->group), task)) return placed;
      if (units_.count(planned.id)) return placed_as_box(planned, item);
    }
    return place_as_box(layout_, item, std::move(task));
  }

  // The whole group of an anchor, or else its units when their turn comes.
  std::optional<Object> place_whole(const PlanGroup& group, PlacementTask task) {
    task.composition = group.composition;
    auto ways = composition::ways_to_stand(plan_, group, layout_.categories(), {{}, 0.0});  // boxes
    if (!ways) return std::nullopt;
    if (ways->size() > most_ways) ways->resize(most_ways);
    if (auto placed = place_ways(*ways, group.id, task)) {
      for (const auto& [member, role] : roles_.by_id())
        if (role.group == group.id && !places_.count(member) && member != task.object.id && may_be_left_out(member))
          places_[member] = std::nullopt;
      return placed;
    }
    for (auto& unit : composition::units_of(ways->front()))
      if (const auto anchor = roles_.id_of(group.id, unit.members.front()); !anchor.empty())
        units_.emplace(anchor, std::move(unit));
    return std::nullopt;
  }

  bool may_be_left_out(const std::string& member) const {
    const PlanItem& item = plan_.items[planned_.at(member).item];
    return item.mount != Mount::surface && !item.asked;
  }

  // Where its members go is known from then on.
  std::optional<Object> place_ways(std::span<const composition::Arranged> ways, const std::string& id,
                                   const PlacementTask& task) {
    std::map<std::string, Object> things;
    const auto thing_of = [&](const composition::Member& member) -> const Object* {
      const std::string known = roles_.id_of(id, member);
      if (known.empty()) return nullptr;
      const auto [at, is_new] = things.try_emplace(known);
      if (is_new) at->second = task_for(plan_, planned_.at(known), layout_).object;
      return &at->second;
    };
    PlaceOptions options;
    options.max_exact_tests = most_exact_tests;
    Random random(0);
    auto placed = place_group(layout_, task, {ways, thing_of}, options, random);
    if (!placed) return std::nullopt;
    for (const auto& object : companions_of(placed->task, placed->placement.object)) places_[object.id] = object;
    return std::move(placed->placement.object);
  }

  const Plan& plan_;
  const composition::Roles roles_;
  std::map<std::string, PlannedObject> planned_;
  const ModelTable boxes_ = {};
  Layout layout_;
  std::set<std::string> tried_;                          ///< groups
  std::map<std::string, composition::Arranged> units_;   ///< by their anchors, of groups that do not stand as one
  std::map<std::string, std::optional<Object>> places_;  ///< of things whose group stands; none: it had no room
  DryRun result_;
};

}  // namespace

DryRun dry_run(const Plan& plan, const KindTable& categories, const Arrangements& arrangements,
               const std::function<bool(const DryRun&)>& is_hopeless) {
  return DryRunning(plan, categories, arrangements).run(is_hopeless);
}

}  // namespace roomgen
