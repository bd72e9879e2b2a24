#include "geometric_relations.h"

namespace roomgen::lab {

namespace {

constexpr double off_edge = 0.005;  // metres, below the rim and above the ground

}  // namespace

double stands_in(const Thing& target, const Thing& anchor) {
  const OrientedBox& vessel = anchor.box();
  const Vec3 foot = target.box().center - Vec3(0, 0, target.box().half.z());
  const double height = foot.z() - (vessel.center.z() - vessel.half.z());
  return vessel.contains(foot) && height > off_edge && height < 2.0 * vessel.half.z() - off_edge
             ? 1.0
             : 0.0;
}

}  // namespace roomgen::lab
