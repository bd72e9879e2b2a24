#include "ensemble.h"

#include <algorithm>
#include <utility>

#include "scene/judgement.h"
#include "scene/rounded_pose.h"

namespace roomgen {

Ensemble::Ensemble(Layout& layout, std::span<const Movable> movables, RugRule rugs)
    : layout_(layout), rugs_(std::move(rugs)), occupancy_(layout.room()), stamps_(movables.size()) {
  for (const auto& movable : movables) {
    objects_.push_back(movable.task.object);
    candidates_.push_back(layout.candidate(movable.task.object));
    footprint_at_.emplace_back(movable.task.object);
    relations_.push_back(movable.relations);
  }
  things_ = floor_things(objects_, layout.categories());
}

Pose Ensemble::pose(std::size_t i) const {
  return {objects_[i].position.head<2>(), objects_[i].position.z(), objects_[i].yaw};
}

void Ensemble::put(std::size_t i, const Pose& pose) {
  Object& object = objects_[i];
  object.position = rounded_position({pose.position.x(), pose.position.y(), pose.bottom});
  object.yaw = rounded_yaw(pose.yaw);
  things_[i].footprint = footprint_at_[i](this->pose(i));
}

// The relation as its targets stand now.
const ResolvedRelation& Ensemble::resolved(BoundRelation& bound) const {
  if (bound.target) {
    bound.relation.targets.front() = footprint(*bound.target);
    bound.relation.target_bottom = bottom(objects_[*bound.target]);
    bound.relation.target_top = top(objects_[*bound.target]);
  }
  if (bound.other) bound.relation.other = footprint(*bound.other);
  return bound.relation;
}

bool Ensemble::holds(std::size_t i) {
  const Subject subject{footprint(i), bottom(objects_[i]), top(objects_[i])};
  return std::all_of(relations_[i].begin(), relations_[i].end(), [&](BoundRelation& bound) {
    return judge(resolved(bound), subject, layout_.room()).held;
  });
}

bool Ensemble::fits_room(std::size_t i) const {
  return layout_.fits_room(candidates_[i], footprint(i), base(i));
}

bool Ensemble::collides(std::size_t i, std::size_t other) const {
  return layout_.collides(candidates_[i], footprint(i), base(i), things_[other]) ||
         !rugs_.keeps(i, footprint(i), other, footprint(other));
}

bool Ensemble::is_sound(std::span<const std::size_t> moved) {
  if (!solids_apart(moved)) return false;
  const Room& room = layout_.room();
  const auto has_zone = [&](const FloorThing& thing) { return has_free_zone(room, things_, thing); };
  if (!std::all_of(things_.begin(), things_.end(), has_zone)) return false;
  bring_occupancy_up_to_date();
  occupancy_.flood();
  return occupancy_.doors_connected() &&
         std::all_of(things_.begin(), things_.end(), [&](const FloorThing& thing) {
           return is_usable(room, things_, thing, occupancy_);
         });
}

bool Ensemble::solids_apart(std::span<const std::size_t> moved) {
  for (std::size_t i : moved)
    for (std::size_t j = 0; j < objects_.size(); ++j)
      if (j != i && layout_.solids().overlap(objects_[i], objects_[j])) return false;
  return true;
}

void Ensemble::bring_occupancy_up_to_date() {
  for (std::size_t i = 0; i < things_.size(); ++i) {
    if (!blocks_floor(objects_[i], *things_[i].category)) continue;
    auto& [there, known] = stamps_[i];
    const Footprint& now = things_[i].footprint;
    if (there && known.center() == now.center() && known.yaw() == now.yaw()) continue;
    if (there) occupancy_.remove(known);
    occupancy_.add(now);
    there = true, known = now;
  }
}

}  // namespace roomgen
