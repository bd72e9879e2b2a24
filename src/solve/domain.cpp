#include "domain.h"

#include <cmath>

#include "score.h"

namespace roomgen {

namespace {

constexpr double room_pitch = 0.10;
// About an anchor: coarser, since the anchor's own places shift it.
constexpr double frame_pitch = 0.15;
constexpr double frame_reach = 2.5;
constexpr std::size_t most_poses = 20000;  // of one thing

}  // namespace

Pose from_frame(const Pose& local, const Footprint& frame, double base, Mount mount) {
  return {frame.to_world(local.position), mount == Mount::surface ? base + local.bottom : local.bottom,
          wrap_angle(frame.yaw() + local.yaw)};
}

Pose to_frame(const Pose& pose, const Footprint& frame, double base, Mount mount) {
  return {frame.to_local(pose.position), mount == Mount::surface ? pose.bottom - base : pose.bottom,
          wrap_angle(pose.yaw - frame.yaw())};
}

void DomainSearch::look(const Object* anchor) {
  if (anchor) layout_.add(*anchor);
  const auto context = make_context(layout_, task_, judged(), 1);
  collect(context, propose_exact(context), anchor, domain_.meaningful);
  if (!wants(context, RelationKind::edge) && !wants(context, RelationKind::corner))
    collect(context, grid_about(context, anchor), anchor, domain_.grid);
  if (anchor) layout_.remove(anchor->id);
}

// Those whose targets are there: the others are asked when everything stands.
std::vector<ResolvedRelation> DomainSearch::judged() const {
  auto relations =
      resolve(task_.object, layout_.room(), layout_.objects(), layout_.categories());
  std::erase_if(relations, [](const ResolvedRelation& relation) {
    return relation.targets.empty() || relation.kind == RelationKind::between;
  });
  return relations;
}

std::vector<Pose> DomainSearch::grid_about(const ProposalContext& context, const Object* anchor) const {
  if (!anchor) return propose_grid(context, room_pitch);
  const double reach = frame_reach + 0.5 * anchor->size.head<2>().norm();
  return propose_grid(context, frame_pitch, Disc{anchor->position.head<2>(), reach});
}

void DomainSearch::collect(const ProposalContext& context, const std::vector<Pose>& poses, const Object* anchor,
                           std::vector<Pose>& found) {
  const auto candidate = layout_.candidate(task_.object);
  const FootprintAt footprint_at(task_.object);
  const Mount mount = task_.object.mount;
  const Footprint frame = anchor ? footprint(*anchor) : Footprint();
  for (const auto& pose : poses) {
    const Footprint area = footprint_at(pose);
    if (!layout_.fits_room(candidate, area, pose.bottom) || !holds_all(context, area, pose.bottom)) continue;
    if (anchor && layout_.collides(candidate, area, pose.bottom, layout_.things().front())) continue;
    const Pose local = anchor ? to_frame(pose, frame, bottom(*anchor), mount) : pose;
    if (found.size() >= most_poses || !is_new(local)) continue;
    found.push_back(local);
    stands_.push_back(pose);
  }
}

bool DomainSearch::is_new(const Pose& pose) {
  constexpr double step = 1e-3;
  return known_
      .insert({std::llround(pose.position.x() / step), std::llround(pose.position.y() / step),
               std::llround(pose.bottom / step), std::llround(wrap_angle(pose.yaw) / step)})
      .second;
}

}  // namespace roomgen
