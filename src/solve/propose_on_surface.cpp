#include "proposals.h"

namespace roomgen {

namespace {

// Beside those that stand on the same support already.
void propose_next_to_others(const ProposalContext& context, const Object& support,
                            std::vector<Pose>& poses) {
  const Vec2 size = size_of(context);
  for (const auto& thing : context.layout.things()) {
    if (thing.object->on != support.id) continue;
    const Footprint& other = thing.footprint;
    for (int turn : {0, 1}) {
      const Vec2 reach =
          other.half() + turned_half(size, turn * pi / 2) + Vec2::Constant(apart_on_surface);
      for (const Vec2& side : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)})
        poses.push_back({other.to_world(side.cwiseProduct(reach)), 0.0,
                         wrap_angle(other.yaw() + turn * pi / 2)});
    }
  }
}

std::vector<Pose> suggested_on(const ProposalContext& context, const Object& support) {
  if (!context.suggestion.location) return {};
  const Vec2& location = *context.suggestion.location;
  const bool has_front = context.task.object.traits.front;
  std::vector<double> turns;
  for (int turn = 0; turn < (has_front ? 4 : 2); ++turn)
    turns.push_back(wrap_angle(support.yaw + turn * pi / 2));
  std::vector<Pose> poses;
  for (double yaw : turns) poses.push_back({location, 0.0, yaw});
  if (!context.suggestion.binds) return poses;
  for (const Vec2& offset : offsets_about_suggestion(0.07))
    for (double yaw : suggested_yaws(context, location + offset, turns))
      poses.push_back({location + offset, 0.0, yaw});
  return poses;
}

}  // namespace

void propose_on_surface(const ProposalContext& context, const Object& support,
                        std::vector<Pose>& poses) {
  const SupportPoses& rests = context.layout.support_poses();
  const Object& object = context.task.object;
  for (const auto& rest : rests.everywhere(object, support))
    poses.push_back(pose_of(rest, support));
  std::vector<Pose> wished = suggested_on(context, support);
  propose_for_relations(context, wished);
  propose_next_to_others(context, support, wished);
  const Footprint area = footprint(support);
  std::vector<SupportPoses::Place> places;
  for (const auto& pose : wished)
    if (contains(area, pose.position))
      places.push_back({area.to_local(pose.position), wrap_angle(pose.yaw - support.yaw)});
  for (const auto& rest : rests.at(object, support, places))
    poses.push_back(pose_of(rest, support));
}

}  // namespace roomgen
