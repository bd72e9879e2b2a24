#include "operations.h"
#include "placing.h"

namespace roomgen {

namespace {

constexpr double slack_of_swap = 0.8;  // metres that a thing may give way when it takes another one's place

// At another one's place: what stands on other things goes onto what carried that one.
Result<Cluster> in_place_of(Draft& draft, Layout& layout, const Cluster& cluster, const Object& other) {
  Cluster going = cluster;
  going.root.on = other.on;
  Pose pose = pose_of(other);
  if (going.root.mount != Mount::surface) {
    pose.bottom = going.root.mount == Mount::floor ? 0.0 : going.root.position.z();
    if (auto there = settled(draft, layout, moved_to(going, pose))) return there;
    if (auto there = settled(draft, layout, moved_to(going, pose), RugEdges::stood_on)) return there;
  }
  Aim aim;
  aim.near_to = pose;
  aim.most_off = slack_of_swap;
  aim.turns_freely = !cluster.root.traits.front;
  return find_place(draft, layout, going, aim);
}

}  // namespace

Status carry_out(Draft& draft, const edit::Swap& swap) {
  const auto first = object_to_change(draft, swap.first);
  if (!first) return first.error();
  const auto second = object_to_change(draft, swap.second);
  if (!second) return second.error();
  if (first->id == second->id) return cannot("swapping takes two things");
  if (first->room != second->room) return cannot(first->id + " and " + second->id + " are in different rooms");
  if (first->mount != second->mount)
    return cannot(first->id + " and " + second->id + " are not put up the same way");
  const Cluster one = whole_of(draft.scene, *first), other = cluster_of(draft.scene, *second);
  auto away = one.ids();
  if (away.count(second->id) || other.ids().count(first->id)) return cannot("one of them stands on the other");
  away.merge(other.ids());
  Layout& layout = draft.shop.layout(draft.scene, first->room, away);
  // The larger one has the fewer choices.
  const bool first_leads = footprint(*first).area() >= footprint(*second).area();
  const Cluster &leader = first_leads ? one : other, &follower = first_leads ? other : one;
  auto led = in_place_of(draft, layout, leader, follower.root);
  if (!led) return led.error();
  layout.add(led->root);
  for (const auto& object : led->carried) layout.add(object);
  auto followed = in_place_of(draft, layout, follower, leader.root);
  if (!followed) return followed.error();
  draft.put(*led);
  draft.put(*followed);
  return {};
}

}  // namespace roomgen
