#include <cmath>
#include <optional>

#include "attempts.h"
#include "builder_steps.h"
#include "consult.h"
#include "fits_as_it_is.h"
#include "prepare.h"

namespace roomgen {

namespace {

// The object where the host wants it.
Result<Object> posed(const Layout& layout, Object object, const WantedPose& wanted) {
  if (object.mount != Mount::surface)
    object =
        at_pose(object, {wanted.position, wanted.bottom.value_or(object.position.z()), wanted.yaw});
  else if (auto rest = resting(layout, object, wanted))
    object = *std::move(rest);
  else
    return Error{Error::Kind::not_found,
                 object.id + " cannot stand there: nothing carries it" +
                     (wanted.on.empty() ? "" : " (wanted: " + wanted.on + ")")};
  object.locked = true;
  return object;
}

}  // namespace

std::optional<Object> resting(const Layout& layout, Object object, const WantedPose& wanted) {
  std::optional<Pose> best;
  for (const auto& support : layout.objects()) {
    if (!wanted.on.empty() && support.id != wanted.on) continue;
    const Footprint below = footprint(support);
    if (!contains(below, wanted.position)) continue;
    const SupportPoses::Place place{
        rotated(Vec2(wanted.position - below.center()), -support.yaw),
        wrap_angle(wanted.yaw - support.yaw)};
    for (const auto& rest : layout.support_poses().at(object, support, {&place, 1})) {
      const Pose pose = pose_of(rest, support);
      const auto far = [&](const Pose& one) {
        return wanted.bottom ? std::abs(one.bottom - *wanted.bottom) : -one.bottom;
      };
      if (!best || far(pose) < far(*best)) best = pose, object.on = support.id;
    }
  }
  if (!best) return std::nullopt;
  return at_pose(object, *best);
}

Status put_at(Work& work, const PlannedObject& planned, const WantedPose& pose, Step& step) {
  const auto asset = asset_for(work, planned);
  if (!asset) return asset.error();
  auto task = prepare(work, planned, *asset);
  if (!task) return task.error();
  const auto object = posed(work.layout(), task->object, pose);
  if (!object) return object.error();
  if (auto status = fits_as_it_is(work.layout(), *object); !status) return status;
  task->object.on = object->on;
  task->location = pose.position;
  task->facing = pose.yaw;
  step.has_assets = true;
  PlaceAdvice given;
  given.relations = task->object.relations;
  given.location = pose.position;
  given.yaw = pose.yaw;
  step.attempts.push_back(begun(*asset, given));
  work.layout().add(*object);
  enter(work, planned, *asset, *std::move(task));
  return {};
}

Status put_by(Work& work, const PlannedObject& planned, const PlaceAdvice& wish, Step& step) {
  const auto asset = asset_for(work, planned);
  if (!asset) return asset.error();
  auto task = prepare(work, planned, *asset);
  if (!task) return task.error();
  auto attempt = try_to_place(work, planned, *asset, wish, 0, *task);
  if (!attempt) return attempt.error();
  if (!attempt->refused.empty()) return Error{Error::Kind::not_found, attempt->refused};
  step.has_assets = true;
  step.attempts.push_back(*std::move(attempt));
  return {};
}

}  // namespace roomgen
