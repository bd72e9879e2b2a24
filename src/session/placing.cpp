#include "placing.h"

#include <algorithm>
#include <cmath>

#include "generate/fits_as_it_is.h"
#include "roomgen/base/text.h"
#include "scene/judgement.h"
#include "solve/fit_rugs.h"
#include "solve/place.h"
#include "solve/support.h"

namespace roomgen {

namespace {

constexpr int most_choices = 10;             // poses that are tried for one that suits all
constexpr double finest_pitch = 0.05;        // metres
constexpr int most_tests_in_the_end = 1500;  // of meshes and reachability
constexpr double same_yaw = 0.02;            // radians, about a degree

bool lies_on_floor(const Object& object) { return object.traits.flat && object.mount == Mount::floor; }
bool stands_on_floor(const Object& object) { return object.mount == Mount::floor && !object.traits.flat; }

bool may_meet(const Object& thing, const Object& rug) {
  return footprint(thing).bounds().overlaps(footprint(rug).bounds());
}

// The height of the rug that it stands on; nothing if it stands partly on one.
std::optional<double> height_on_rugs(const Object& thing, std::span<const Object> objects, const ModelTable& models) {
  double height = 0.0;
  for (const auto& rug : objects) {
    if (!lies_on_floor(rug) || !may_meet(thing, rug)) continue;
    const RugStand stand = stand_to_rug(thing, rug, models);
    if (stand == RugStand::partly) return std::nullopt;
    if (stand == RugStand::on) height = std::max(height, top(rug));
  }
  return height;
}

// What stands on the rug's edge, unless it did so before.
std::string on_edge_of(const Object& rug, const Object* before, std::span<const Object> objects,
                       const ModelTable& models) {
  for (const auto& thing : objects)
    if (stands_on_floor(thing) && may_meet(thing, rug) && stand_to_rug(thing, rug, models) == RugStand::partly &&
        !(before && stand_to_rug(thing, *before, models) == RugStand::partly))
      return thing.id;
  return "";
}

Status settle_root(const Draft& draft, const Layout& layout, RugEdges edges, Cluster& cluster) {
  if (lies_on_floor(cluster.root)) {
    if (edges == RugEdges::stood_on) return {};
    const auto id = on_edge_of(cluster.root, find_object(draft.scene, cluster.root.id), layout.objects(),
                               draft.shop.models());
    return id.empty() ? Status() : cannot(cluster.root.id + " cannot lie there: " + id + " would stand on its edge");
  }
  if (!stands_on_floor(cluster.root)) return {};
  Object on_floor = cluster.root;
  on_floor.position.z() = 0.0;
  const auto height = height_on_rugs(on_floor, layout.objects(), draft.shop.models());
  if (!height && edges == RugEdges::kept_free)
    return cannot(cluster.root.id + " cannot stand there: it would be on the edge of a rug");
  Pose pose = pose_of(on_floor);
  pose.bottom = height.value_or(0.0);
  if (pose.bottom != cluster.root.position.z()) cluster = moved_to(cluster, pose);
  return {};
}

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
    if (relation.kind == RelationKind::on || relation.kind == RelationKind::inside) task.object.on = relation.target;
  const bool is_said = std::any_of(aim.asked.begin(), aim.asked.end(),
                                   [](const Relation& one) { return one.kind == RelationKind::on; });
  if (!is_said && !aim.near_to) (void)choose_support(layout, "", 0, task);
  if (layout.find(task.object.on)) return {};
  return cannot("nothing is there to carry " + task.object.id);
}

bool is_near_enough(const Object& object, const Aim& aim) {
  if (!aim.near_to) return true;
  const double off = (object.position.head<2>() - aim.near_to->position).norm();
  return off <= aim.most_off &&
         (aim.turns_freely || std::abs(wrap_angle(object.yaw - aim.near_to->yaw)) <= same_yaw);
}

// The last resort looks at all points, in the order of how near they are.
PlaceOptions all_points(const Layout& layout, PlacementTask& task) {
  PlaceOptions options;
  options.pitch = finest_pitch;
  options.max_exact_tests = most_tests_in_the_end;
  options.fusion.ordinal_ranks = true;
  task.usual = false;
  if (!task.location) {
    const Bounds2 box = bounds(layout.room().polygon);
    task.location = 0.5 * (box.low + box.high);
    task.binding = false;
  }
  return options;
}

/// One thing's way to its place.
class PlaceSearch {
 public:
  PlaceSearch(Draft& draft, Layout& layout, const Cluster& cluster, const Aim& aim)
      : draft_(draft), layout_(layout), cluster_(cluster), aim_(aim) {}

  Result<Cluster> run(Effort effort) {
    PlacementTask task = task_for(layout_, cluster_, aim_, draft_.shop.kinds());
    if (auto status = choose_carrier(layout_, aim_, task); !status) return status.error();
    if (auto found = first_that_suits(task, PlaceOptions())) return *found;
    if (effort == Effort::thorough && task.object.mount == Mount::floor)
      if (auto found = first_that_suits(task, all_points(layout_, task))) return *found;
    return cannot(why_);
  }

 private:
  std::optional<Cluster> first_that_suits(const PlacementTask& task, PlaceOptions options) {
    for (int choice = 0; choice < most_choices; ++choice) {
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

  std::optional<Cluster> suited(const Object& placed) {
    Cluster cluster = cluster_;
    cluster.root.on = placed.on;
    cluster = moved_to(cluster, pose_of(placed));
    cluster.root.relations = placed.relations;
    if (!is_near_enough(cluster.root, aim_)) return note("there is no room near enough"), std::nullopt;
    auto found = settled(draft_, layout_, std::move(cluster));
    if (!found) return note(found.error().message), std::nullopt;
    const auto lost = lost_relations(found->root, aim_.asked, draft_.scene, draft_.shop.kinds());
    if (!lost.empty()) return note(no_place_where(lost)), std::nullopt;
    const auto idle = lost_relations(found->root, found->root.relations, draft_.scene, draft_.shop.kinds());
    std::erase_if(found->root.relations, [&](const Relation& one) {
      return std::find(idle.begin(), idle.end(), one) != idle.end();
    });
    return *std::move(found);
  }

  std::string no_place_where(const std::vector<Relation>& lost) const {
    std::vector<std::string> texts;
    for (const auto& relation : lost)
      texts.push_back(std::string(name(relation.kind)) + (relation.target.empty() ? "" : " " + relation.target));
    return "there is no free place for " + cluster_.root.id + " " + join(texts, ", ");
  }

  void note(const std::string& why) {
    if (why_.empty()) why_ = why;
  }

  Draft& draft_;
  Layout& layout_;
  const Cluster& cluster_;
  const Aim& aim_;
  std::string why_;
};

}  // namespace

Result<Cluster> settled(const Draft& draft, Layout& layout, Cluster cluster, RugEdges edges) {
  if (auto status = settle_root(draft, layout, edges, cluster); !status) return status.error();
  if (auto status = fits_as_it_is(layout, cluster.root); !status) return status.error();
  layout.add(cluster.root);
  std::size_t added = 0;
  Status status;
  for (; added < cluster.carried.size() && status; ++added) {
    status = fits_as_it_is(layout, cluster.carried[added]);
    if (status) layout.add(cluster.carried[added]);
  }
  for (const auto& object : cluster.carried) layout.remove(object.id);
  layout.remove(cluster.root.id);
  if (!status) return status.error();
  return cluster;
}

Result<Cluster> exactly_at(Draft& draft, const Cluster& cluster, const Pose& pose, RugEdges edges) {
  return settled(draft, draft.layout_without(cluster), moved_to(cluster, pose), edges);
}

Result<Cluster> find_place(Draft& draft, Layout& layout, const Cluster& cluster, const Aim& aim,
                           Effort effort) {
  return PlaceSearch(draft, layout, cluster, aim).run(effort);
}

Result<Cluster> there_or_near(Draft& draft, const Cluster& cluster, const Pose& pose, double most_off) {
  auto there = exactly_at(draft, cluster, pose);
  if (there) return there;
  Aim aim;
  aim.near_to = pose;
  aim.most_off = most_off;
  aim.kept = cluster.root.relations;
  auto near = find_place(draft, draft.layout_without(cluster), cluster, aim);
  if (near) return near;
  auto on_edge = exactly_at(draft, cluster, pose, RugEdges::stood_on);
  return on_edge ? on_edge : there;
}

std::vector<Relation> lost_relations(const Object& object, const std::vector<Relation>& relations, const Scene& scene,
                                     const KindTable& kinds) {
  Object asked = object;
  asked.relations = relations;
  const Room& room = room_of(scene, object);
  std::vector<Object> others;
  for (const auto& other : scene.objects)
    if (other.room == object.room && other.id != object.id) others.push_back(other);
  const auto resolved = resolve(asked, room, others, kinds);
  std::vector<Relation> lost;
  for (std::size_t i = 0; i < resolved.size(); ++i) {
    const bool carried = relations[i].kind == RelationKind::on && object.on == relations[i].target;
    if (!carried && !judge(resolved[i], {footprint(object), bottom(object), top(object)}, room).held)
      lost.push_back(relations[i]);
  }
  return lost;
}

std::vector<std::string> new_rug_edges(const Scene& before, const Draft& draft) {
  const auto stands_on_edge = [&](const Object* thing, const Object* rug) {
    return thing && rug && may_meet(*thing, *rug) && stand_to_rug(*thing, *rug, draft.shop.models()) == RugStand::partly;
  };
  std::vector<std::string> edges;
  for (const auto& rug : draft.scene.objects) {
    if (!lies_on_floor(rug)) continue;
    for (const auto& thing : draft.scene.objects)
      if (stands_on_floor(thing) && thing.room == rug.room && stands_on_edge(&thing, &rug) &&
          !stands_on_edge(find_object(before, thing.id), find_object(before, rug.id)))
        edges.push_back(thing.id + " stands on the edge of " + rug.id);
  }
  return edges;
}

void settle_heights(Draft& draft, const std::string& room) {
  const std::vector<Object> before = draft.scene.objects;
  for (const auto& object : before) {
    if (object.room != room || !stands_on_floor(object)) continue;
    Object on_floor = object;
    on_floor.position.z() = 0.0;
    std::vector<Object> rugs;
    for (const auto& other : before)
      if (other.room == room && lies_on_floor(other)) rugs.push_back(other);
    const auto height = height_on_rugs(on_floor, rugs, draft.shop.models());
    if (!height || *height == object.position.z()) continue;
    Pose pose = pose_of(object);
    pose.bottom = *height;
    draft.put(moved_to(cluster_of(draft.scene, object), pose));
  }
}

}  // namespace roomgen
