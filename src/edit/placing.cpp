#include "placing.h"

#include <algorithm>

#include "generate/fits_as_it_is.h"
#include "rug_edges.h"
#include "scene/judgement.h"
#include "solve/fit_rugs.h"

namespace roomgen {

namespace {

Status settle_root(const Draft& draft, const Layout& layout, RugEdges edges, Cluster& cluster) {
  if (lies_on_floor(cluster.root)) {
    cluster.root.position.z() = height_of_rug(cluster.root, layout.objects());
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

const Object* hook_of(const Scene& scene, const std::vector<Relation>& relations) {
  for (const auto& relation : relations)
    if (relation.kind == RelationKind::hang_from)
      if (const Object* hook = find_object(scene, relation.target)) return hook;
  return nullptr;
}

Result<Cluster> hung(Draft& draft, Cluster cluster, const std::vector<Relation>& relations) {
  const Object* hook = hook_of(draft.scene, relations);
  if (!hook) return cluster;
  Object& root = cluster.root;
  root.mount = Mount::ceiling;
  root.on.clear();
  root.size.z() *= 1.0 - root.asset.wires;
  root.asset.wires = 0.0;
  if (const auto model = draft.shop.fetch_model(root.asset); !model) return model.error();
  Pose pose = pose_of(root);
  pose.bottom = std::max(0.0, bottom(*hook) - root.size.z());
  return moved_to(cluster, pose);
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

std::vector<Relation> held_relations(const Object& object, const std::vector<Relation>& relations, const Scene& scene,
                                     const KindTable& kinds) {
  const auto lost = lost_relations(object, relations, scene, kinds);
  auto held = relations;
  std::erase_if(held, [&](const Relation& one) { return std::find(lost.begin(), lost.end(), one) != lost.end(); });
  return held;
}

Vec2 middle_of(const Draft& draft, const Layout& layout, const Aim& aim) {
  if (aim.near_to) return aim.near_to->position;
  for (const auto& relation : aim.asked)
    if (const Object* target = find_object(draft.scene, relation.target)) return target->position.head<2>();
  const Bounds2 box = bounds(layout.room().polygon);
  return 0.5 * (box.low + box.high);
}

std::vector<std::string> new_rug_edges(const Scene& before, const Draft& draft) {
  const auto is_on_edge = [&](const Object* thing, const Object* rug) {
    return thing && rug && stands_on_edge(*thing, *rug, draft.shop.models());
  };
  std::vector<std::string> edges;
  for (const auto& rug : draft.scene.objects) {
    if (!lies_on_floor(rug)) continue;
    for (const auto& thing : draft.scene.objects)
      if (stands_on_floor(thing) && thing.room == rug.room && is_on_edge(&thing, &rug) &&
          !is_on_edge(find_object(before, thing.id), find_object(before, rug.id)))
        edges.push_back(thing.id + " stands on the edge of " + rug.id);
  }
  return edges;
}

void settle_heights(Draft& draft, const std::string& room) {
  const std::vector<Object> before = draft.scene.objects;
  std::vector<Object> rugs;
  for (const auto& object : before)
    if (object.room == room && lies_on_floor(object)) rugs.push_back(object);
  pile_rugs(rugs);
  for (const auto& rug : rugs) draft.put(Cluster{rug, {}});
  for (const auto& object : before) {
    if (object.room != room || !stands_on_floor(object)) continue;
    Object on_floor = object;
    on_floor.position.z() = 0.0;
    // On the edge of one it stands on the floor.
    const double height = height_on_rugs(on_floor, rugs, draft.shop.models()).value_or(0.0);
    if (height == object.position.z()) continue;
    Pose pose = pose_of(object);
    pose.bottom = height;
    draft.put(moved_to(cluster_of(draft.scene, object), pose));
  }
}

}  // namespace roomgen
