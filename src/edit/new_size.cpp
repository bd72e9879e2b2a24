#include "new_size.h"

#include <algorithm>

namespace roomgen {

double& side_of_size(Vec3& size, const std::string& side) {
  if (side == "height") return size.z();
  if (side == "depth") return size.y();
  if (side == "width") return size.x();
  if ((side == "shorter" || side == "longest") && size.z() > std::max(size.x(), size.y()))
    return size.z();
  return size.x() >= size.y() ? size.x() : size.y();
}

Vec3 resized(const Vec3& size, const NewSize& change) {
  Vec3 now = size;
  if (change.side == "all") return change.factor > 0.0 ? Vec3(change.factor * size) : now;
  double& side = side_of_size(now, change.side);
  if (change.exact) side = *change.exact;
  else if (change.more) side += *change.more;
  else side *= change.factor;
  return now;
}

}  // namespace roomgen
