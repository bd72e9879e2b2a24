#include "grouping.h"
#include "placing.h"

namespace roomgen {

namespace {

constexpr double slack_of_group = 0.6;  // metres that a thing may give way when it comes along with what it stands around

}  // namespace

Status move_group_to(Draft& draft, const Object& leader, const Pose& pose) {
  const auto group = group_of(draft.scene, leader);
  const auto moved = moved_to(group, pose);
  Layout& layout = draft.shop.layout(draft.scene, leader.room, ids_of(group));
  for (const auto& cluster : moved) {
    if (cluster.root.locked) return cannot(cluster.root.id + " would come along, and is locked; unlock it first");
    auto there = settled(draft, layout, cluster);
    if (!there) there = settled(draft, layout, cluster, RugEdges::stood_on);
    if (!there) return there.error();
    layout.add(there->root);
    for (const auto& carried : there->carried) layout.add(carried);
    draft.put(*there);
    draft.named.insert(cluster.root.id);
  }
  return {};
}

Status take_group_along(Draft& draft, Draft& moved, const std::vector<Cluster>& group, const Object& leader) {
  const auto wanted = moved_to(group, pose_of(leader));
  for (std::size_t i = 1; i < group.size(); ++i) {
    const Cluster there = in_room(wanted[i], leader.room);
    if (there.root.locked) return cannot(there.root.id + " would come along, and is locked; unlock it first");
    auto place = there_or_near(moved, there, pose_of(there.root), slack_of_group);
    if (!place) {
      Aim aim;
      aim.asked = group[i].root.relations;
      place = find_place(moved, moved.layout_without(there), there, aim);
    }
    if (!place) return cannot(there.root.id + " cannot come along: " + place.error().message);
    place->root.relations = group[i].root.relations;
    moved.put(*place);
    moved.named.insert(there.root.id);
  }
  restore_order(draft.scene.objects, moved.scene.objects);
  draft.take_over(std::move(moved));
  return {};
}

}  // namespace roomgen
