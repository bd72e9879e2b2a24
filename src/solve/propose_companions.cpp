#include "proposals.h"

namespace roomgen {

namespace {

// At the middle of the room and of its walls, whichever way round.
void propose_in_middle(const ProposalContext& context, std::vector<Pose>& poses) {
  const Bounds2 box = bounds(context.layout.room().polygon);
  for (double yaw : context.layout.wall_yaws())
    poses.push_back({0.5 * (box.low + box.high), mounting_height(context), yaw});
}

}  // namespace

Bounds2 box_with_companions(const PlacementTask& task) {
  const Vec2 half = 0.5 * task.object.size.head<2>();
  Bounds2 box{-half, half};
  for (const auto& companion : task.companions) {
    const Object& object = companion.object;
    if (object.mount != Mount::floor || (object.traits.flat && !task.object.traits.flat)) continue;
    const Footprint own(companion.position, object.size.head<2>(), companion.yaw,
                        object.traits.round);
    for (const Vec2& corner : own.outline()) box.add(corner);
  }
  return box;
}

// The box around all of them is put where a thing of its size would be.
void propose_with_companions(const ProposalContext& context, std::vector<Pose>& poses) {
  if (context.task.companions.empty()) return;
  const Bounds2 box = box_with_companions(context.task);
  PlacementTask whole = context.task;
  whole.companions.clear();
  whole.object.size.head<2>() = box.size();
  whole.object.traits.round = false;
  const ProposalContext of_whole{context.layout, whole, context.relations, 1, context.suggestion};
  std::vector<Pose> found;
  if (!wants(context, RelationKind::middle)) propose_at_walls(of_whole, found);
  propose_in_middle(of_whole, found);
  const Vec2 middle = 0.5 * (box.low + box.high);
  for (Pose pose : found) {
    pose.position -= rotated(middle, pose.yaw);
    poses.push_back(pose);
  }
}

}  // namespace roomgen
