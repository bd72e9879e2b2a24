#include <algorithm>
#include <cmath>

#include "geometric_relations.h"
#include "object_relations.h"
#include "room_relations.h"

namespace roomgen::lab {

namespace {

constexpr double back_tolerance = 0.05;  // metres, of furniture that stands at a wall
constexpr double sheet_depth = 0.05;     // metres
constexpr double under_range = 0.3;      // metres from the wall, as "against" a wall
constexpr double least_height = 0.1;  // metres over the floor: what stands at a wall does not hang

bool hangs(const Thing& thing, std::span<const Thing> walls) {
  return thing.box().center.z() - thing.box().half.z() > least_height &&
         sceneeval::on_wall(thing, walls) > sceneeval::satisfied_above;
}

// The target's centre and how far it reaches, in the frame of the anchor.
struct Seen {
  Vec3 at;
  Vec2 half;
};

Seen seen_from(const OrientedBox& anchor, const OrientedBox& target) {
  const Vec2 x = rotated({1, 0}, anchor.yaw);
  return {anchor.to_local(target.center), {target.half_extent(x), target.half_extent(left_of(x))}};
}

// Near the wall at the sheet's back, whether narrower or wider than it.
bool shares_wall(const Seen& target, const Vec3& sheet) {
  return target.at.y() + target.half.y() >= sheet.y() - under_range &&
         std::abs(target.at.x()) <= std::max(sheet.x(), target.half.x());
}

double beyond_sheet(const Thing& target, const Thing& anchor, std::span<const Thing> walls,
                    double up) {
  const Vec3& sheet = anchor.box().half;
  if (2.0 * sheet.y() > sheet_depth || !hangs(anchor, walls)) return 0.0;
  const Seen seen = seen_from(anchor.box(), target.box());
  return up * seen.at.z() >= sheet.z() && shares_wall(seen, sheet) ? 1.0 : 0.0;
}

}  // namespace

double behind_on_wall(const Thing& target, const Thing& anchor, std::span<const Thing> walls) {
  const Seen seen = seen_from(anchor.box(), target.box());
  const Vec3& half = anchor.box().half;
  const bool behind = seen.at.y() > 0.0 &&
                      seen.at.y() + seen.half.y() >= half.y() - back_tolerance &&
                      std::abs(seen.at.x()) <= half.x();
  return behind && hangs(target, walls) ? 1.0 : 0.0;
}

double above_sheet(const Thing& target, const Thing& anchor, std::span<const Thing> walls) {
  return beyond_sheet(target, anchor, walls, 1.0);
}

double under_sheet(const Thing& target, const Thing& anchor, std::span<const Thing> walls) {
  return beyond_sheet(target, anchor, walls, -1.0);
}

}  // namespace roomgen::lab
