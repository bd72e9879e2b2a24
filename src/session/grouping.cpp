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
  std::vector<Cluster> group = {cluster_of(scene, leader)};
  const auto own = group.front().ids();
  for (const auto& object : scene.objects)
    if (object.on.empty() && !own.count(object.id) && object.room == leader.room && belongs_to(object, leader.id))
      group.push_back(cluster_of(scene, object));
  return group;
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
