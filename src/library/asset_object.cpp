#include "asset_object.h"

#include <algorithm>
#include <cmath>

namespace roomgen {

namespace {

// The share by which a mesh is stretched or squeezed at most, and where somebody named the length: up to what
// is no other size (library/looks.h).
constexpr double most_asset_stretch = 0.12, most_said_stretch = 0.3;
constexpr double usual_length = 0.02;  // as near to the kind's own a length says nothing

}  // namespace

bool is_length_told(double wanted, double usual) { return std::abs(wanted / usual - 1.0) > usual_length; }

Vec3 fitted_size(const AssetInfo& asset, const Kind& kind, Mount mount, const Vec3& wanted, bool asked) {
  Vec3 size = asset.size;
  if (mount != Mount::floor || asset.ref.procedural) return size;
  Vec3 factor = wanted.cwiseQuotient(size);
  if (asset.round) factor.head<2>().setConstant(factor.head<2>().mean());
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_said = asked && is_length_told(wanted[axis], kind.size[axis]);
    const double most = is_said ? most_said_stretch : axis < 2 ? most_asset_stretch : 0.0;
    size[axis] *= std::clamp(factor[axis], 1.0 - most, 1.0 + most);
  }
  return size;
}

Object object_of_asset(const AssetInfo& asset, const Kind& kind, const Vec3& size, const Model* model) {
  Object object;
  object.asset = asset.ref;
  object.stand_in = asset.stand_in;
  object.traits = kind.traits;
  object.traits.front = kind.traits.front && asset.has_front;
  object.size = size;
  object.traits.round = asset.round && (!model || keeps_to_ellipse(*model, size));
  object.mount = kind.mount;
  return object;
}

}  // namespace roomgen
