#include "asset_object.h"

#include <algorithm>
#include <cmath>

#include "ranking.h"
#include "seen_assets.h"

namespace roomgen {

namespace {

// The share by which a mesh that nobody looked at is stretched or squeezed at most, and where
// somebody named the length: up to what is no other size.
constexpr double most_asset_stretch = 0.12, most_said_stretch = 0.25;
constexpr double usual_length = 0.02;  // as near to the kind's own a length says nothing
constexpr double most_unusual = 1.4;   // by this factor it is unusual, where nobody named a size
constexpr double most_factor = 100.0;  // whatever who saw it allows
constexpr double least_said = 0.05;    // metres: thinner than this, thickness is nobody's wish

double bounded(double factor, double share) { return std::clamp(factor, 1.0 - share, 1.0 + share); }

Vec3 turned(const Vec3& size) { return {size.y(), size.x(), size.z()}; }

Vec3 fitted_as_it_is(const AssetInfo& asset, const Vec3& usual, const Vec3& wanted) {
  const SeenAsset* seen = seen_asset(asset.ref);
  const bool is_furniture = asset.mount == Mount::floor;
  Vec3 factor = wanted.cwiseQuotient(asset.size);
  for (int axis = 0; axis < 3; ++axis) {
    const double unsaid = is_furniture && axis < 2 ? most_asset_stretch : 0.0;
    const double said = seen ? most_factor : is_furniture ? most_said_stretch : 0.0;
    factor[axis] = bounded(factor[axis], is_length_told(wanted[axis], usual[axis]) ? said : unsaid);
  }
  // Lengths that hang together get their mean, and each what the mesh bears.
  const int alike = seen ? seen->stretch.alike : asset.round ? 2 : 0;
  if (alike > 0) factor.head(alike).setConstant(factor.head(alike).mean());
  for (std::size_t axis = 0; seen && axis < 3; ++axis) {
    const Interval& range = seen->stretch.factors[axis];
    factor[static_cast<int>(axis)] =
        std::clamp(factor[static_cast<int>(axis)], range.low, range.high);
  }
  return asset.size.cwiseProduct(factor);
}

}  // namespace

bool is_length_told(double wanted, double usual) { return std::abs(wanted / usual - 1.0) > usual_length; }

Vec3 fitted_size(const AssetInfo& asset, const Vec3& usual, const Vec3& wanted) {
  if (asset.ref.procedural) return asset.size;
  const double as_it_is = size_similarity(asset.size, wanted);
  if (!asset.has_front && size_similarity(asset.size, turned(wanted)) > as_it_is)
    return fitted_as_it_is(asset, turned(usual), turned(wanted));
  return fitted_as_it_is(asset, usual, wanted);
}

std::optional<int> far_off_side(const Vec3& have, const Vec3& usual, const Vec3& wanted,
                                double off_said) {
  int worst = 0;
  double most = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::max(have[axis], wanted[axis]) <= least_said) continue;
    const double off = std::max(have[axis] / wanted[axis], wanted[axis] / have[axis]);
    const double accepted = is_length_told(wanted[axis], usual[axis]) ? off_said : most_unusual;
    if (off / accepted > most) worst = axis, most = off / accepted;
  }
  return most > 1.0 ? std::optional(worst) : std::nullopt;
}

bool contradicts_size(const AssetInfo& asset, const Vec3& usual, const Vec3& wanted, double off) {
  const Vec3 size = fitted_size(asset, usual, wanted);
  if (!far_off_side(size, usual, wanted, off)) return false;
  return asset.has_front || far_off_side(turned(size), usual, wanted, off);
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
