#include "rug_rule.h"

#include "collision/low_parts.h"
#include "collision/solids.h"
#include "rug_place.h"

namespace roomgen {

namespace {

std::vector<Footprint> in_frame_of(const Object& thing, std::vector<Footprint> parts) {
  const Footprint frame = footprint(thing);
  for (auto& part : parts) part = Footprint(frame.to_local(part.center()), 2.0 * part.half(), part.yaw() - thing.yaw);
  return parts;
}

std::vector<Footprint> in_room(const Footprint& frame, const std::vector<Footprint>& parts) {
  std::vector<Footprint> placed;
  for (const auto& part : parts)
    placed.emplace_back(frame.to_world(part.center()), 2.0 * part.half(), frame.yaw() + part.yaw());
  return placed;
}

}  // namespace

RugRule::RugRule(std::span<const Object> objects, const ModelTable& models) {
  for (std::size_t r = 0; r < objects.size(); ++r) {
    const Object& rug = objects[r];
    if (!rug.traits.flat || rug.mount != Mount::floor) continue;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const Object& thing = objects[i];
      if (i == r || thing.mount != Mount::floor) continue;
      const Footprint own = footprint(thing);
      const bool lies_over = thing.traits.flat && may_lie_over(own, footprint(rug));
      const RugStand stand = lies_over           ? RugStand::on
                             : thing.traits.flat ? stand_of({&own, 1}, footprint(rug))
                                                 : stand_to_rug(thing, rug, models);
      const auto parts = lies_over           ? std::vector{core_of_rug(own)}
                         : thing.traits.flat ? std::vector{own}
                                             : low_parts(thing, models, low_over(rug));
      if (stand != RugStand::partly) stands_[{i, r}] = {stand, in_frame_of(thing, parts)};
    }
  }
}

bool RugRule::keeps(std::size_t a, const Footprint& at_a, std::size_t b, const Footprint& at_b) const {
  if (stands_.empty()) return true;
  const auto kept = [&](std::size_t thing, const Footprint& at, std::size_t rug, const Footprint& lies) {
    const auto found = stands_.find({thing, rug});
    return found == stands_.end() || stand_of(in_room(at, found->second.parts), lies) == found->second.stand;
  };
  return kept(a, at_a, b, at_b) && kept(b, at_b, a, at_a);
}

}  // namespace roomgen
