#include <algorithm>

#include "acceptance.h"
#include "placing.h"
#include "solve/place.h"
#include "solve/support.h"

namespace roomgen {

namespace {

constexpr int most_choices = 4;              // of the solver, where what it carries does not fit along
constexpr int most_tests_in_the_end = 1500;  // of meshes and reachability

bool says_on(const Relation& relation) { return relation.kind == RelationKind::on; }

PlacementTask task_for(const Layout& layout, const Cluster& cluster, const Aim& aim, const KindTable& kinds) {
  PlacementTask task;
  task.object = cluster.root;
  if (task.object.mount == Mount::floor) task.object.position.z() = 0.0;
  task.object.relations = aim.asked;
  task.object.relations.insert(task.object.relations.end(), aim.kept.begin(), aim.kept.end());
  task.wishes = static_cast<int>(aim.asked.size());
  task.asked = true;
  task.usual = aim.usual;
  for (const auto& other : layout.objects())
    if (kinds.is_a(other.category, cluster.root.category)) ++task.of_its_kind;
  const Footprint frame = footprint(cluster.root);
  for (const auto& object : cluster.carried)
    if (object.on.empty())
      task.companions.push_back({object, frame.to_local(object.position.head<2>()), wrap_angle(object.yaw - cluster.root.yaw)});
  if (!aim.near_to) return task;
  task.location = aim.near_to->position;
  if (!aim.turns_freely) task.facing = aim.near_to->yaw;
  task.binding = true;
  return task;
}

// Which thing carries it: as it is asked, else the one on which it stands, else one that may.
Status choose_carrier(const Layout& layout, const Aim& aim, PlacementTask& task) {
  if (task.object.mount != Mount::surface) return {};
  for (const auto& relation : aim.asked)
    if (says_on(relation) || relation.kind == RelationKind::inside) task.object.on = relation.target;
  const bool is_said = std::any_of(aim.asked.begin(), aim.asked.end(), says_on);
  if (!is_said && !aim.near_to) (void)choose_support(layout, "", 0, task);
  if (layout.find(task.object.on)) return {};
  return cannot("nothing is there to carry " + task.object.id);
}

/// One thing's way to its place.
class PlaceSearch {
 public:
  PlaceSearch(Draft& draft, Layout& layout, const Cluster& cluster, const Aim& aim)
      : draft_(draft), layout_(layout), cluster_(cluster), aim_(aim) {}

  Result<Cluster> run(Effort effort) {
    PlacementTask task = task_for(layout_, cluster_, aim_, draft_.shop.kinds());
    if (auto status = choose_carrier(layout_, aim_, task); !status) return status.error();
    Acceptance accepts(draft_, layout_, task.object, aim_);
    if (auto found = best_of_solver(task, accepts)) return *found;
    if (effort == Effort::thorough && task.object.mount == Mount::floor)
      if (auto found = first_of_floor(task, accepts)) return *found;
    const std::string lack = accepts.why();
    return cannot(lack.empty() ? why_ : lack);
  }

 private:
  std::optional<Cluster> best_of_solver(const PlacementTask& task, Acceptance& accepts) {
    PlaceOptions options;
    options.except = aim_.except;
    options.cancel = draft_.cancel;
    options.accepts = [&](const Pose& pose) { return accepts(pose); };
    for (int choice = 0; choice < most_choices && !draft_.cancel.cancelled(); ++choice) {
      auto placed = place(layout_, task, {}, options, draft_.random);
      if (!placed) {
        if (why_.empty()) why_ = placed.error().message;
        return std::nullopt;
      }
      if (auto found = suited(placed->object)) return found;
      options.except.push_back(pose_of(placed->object));
    }
    return std::nullopt;
  }

  std::optional<Cluster> first_of_floor(const PlacementTask& task, Acceptance& accepts) {
    int tests_left = most_tests_in_the_end;
    for (const auto& pose : floor_points(layout_, task.object, aim_, middle_of(draft_, layout_, aim_))) {
      if (draft_.cancel.cancelled()) break;
      if (!accepts(pose)) continue;
      if (tests_left-- == 0) break;
      if (auto found = suited(at_pose(task.object, pose))) return found;
    }
    return std::nullopt;
  }

  std::optional<Cluster> suited(const Object& placed) {
    Cluster cluster = cluster_;
    cluster.root.on = placed.on;
    cluster = moved_to(cluster, pose_of(placed));
    cluster.root.relations = placed.relations;
    auto found = settled(draft_, layout_, std::move(cluster));
    if (!found) {
      if (why_.empty()) why_ = found.error().message;
      return std::nullopt;
    }
    // Rounded as files hold it, it may just miss what it held.
    if (!lost_relations(found->root, aim_.asked, draft_.scene, draft_.shop.kinds()).empty()) return std::nullopt;
    found->root.relations = held_relations(found->root, found->root.relations, draft_.scene, draft_.shop.kinds());
    return *std::move(found);
  }

  Draft& draft_;
  Layout& layout_;
  const Cluster& cluster_;
  const Aim& aim_;
  std::string why_;
};

}  // namespace

Result<Cluster> find_place(Draft& draft, Layout& layout, const Cluster& cluster, const Aim& aim, Effort effort) {
  return PlaceSearch(draft, layout, cluster, aim).run(effort);
}

}  // namespace roomgen
