#include "grouping.h"

#include <algorithm>

namespace roomgen {

namespace {

bool belongs_to(const Object& object, const std::string& id) {
  const auto has = [&](RelationKind kind) {
    return std::find(object.relations.begin(), object.relations.end(), Relation{kind, id}) != object.relations.end();
  };
  return has(RelationKind::around) || has(RelationKind::face_to);
}

}  // namespace

std::vector<Cluster> group_of(const Scene& scene, const Object& leader) {
  std::vector<Cluster> group = {whole_of(scene, leader)};
  const auto own = group.front().ids();
  for (const auto& object : scene.objects)
    if (object.on.empty() && !own.count(object.id) && object.room == leader.room && belongs_to(object, leader.id))
      group.push_back(cluster_of(scene, object));
  return group;
}

namespace {

bool stands_to(const Object& object, const std::string& id) {
  return std::any_of(object.relations.begin(), object.relations.end(), [&](const Relation& one) {
    return one.target == id && one.kind != RelationKind::far;
  });
}

}  // namespace

std::vector<Cluster> related_group_of(const Scene& scene, const Object& thing) {
  std::vector<Cluster> group = {cluster_of(scene, thing)};
  std::set<std::string> known = group.front().ids();
  for (std::size_t i = 0; i < group.size(); ++i)
    for (const auto& object : scene.objects) {
      const bool is_free = object.on.empty() && object.room == thing.room && !known.count(object.id);
      if (!is_free || (!stands_to(object, group[i].root.id) && !stands_to(group[i].root, object.id))) continue;
      group.push_back(cluster_of(scene, object));
      for (const auto& id : group.back().ids()) known.insert(id);
    }
  order_by_relations(group);
  return group;
}

void order_by_relations(std::vector<Cluster>& things) {
  std::stable_sort(things.begin(), things.end(), [](const Cluster& a, const Cluster& b) {
    return footprint(a.root).area() > footprint(b.root).area();
  });
  std::vector<Cluster> ordered;
  while (!things.empty()) {
    const auto waits = [&](const Cluster& one) {
      return std::any_of(things.begin(), things.end(), [&](const Cluster& other) {
        return other.root.id != one.root.id && stands_to(one.root, other.root.id);
      });
    };
    // Where things stand to each other in a ring, the largest is the first.
    auto next = std::find_if_not(things.begin(), things.end(), waits);
    if (next == things.end()) next = things.begin();
    ordered.push_back(std::move(*next));
    things.erase(next);
  }
  things = std::move(ordered);
}

std::vector<Cluster> moved_to(const std::vector<Cluster>& group, const Pose& pose) {
  const Object& leader = group.front().root;
  const Pose was = pose_of(leader);
  const double turn = wrap_angle(pose.yaw - was.yaw);
  std::vector<Cluster> moved = {moved_to(group.front(), pose)};
  for (std::size_t i = 1; i < group.size(); ++i) {
    Pose there = pose_of(group[i].root);
    there.position = pose.position + rotated(Vec2(there.position - was.position), turn);
    there.yaw = wrap_angle(there.yaw + turn);
    moved.push_back(moved_to(group[i], there));
  }
  return moved;
}

std::set<std::string> ids_of(const std::vector<Cluster>& group) {
  std::set<std::string> ids;
  for (const auto& cluster : group) ids.merge(cluster.ids());
  return ids;
}

}  // namespace roomgen
