#include "asset_object.h"

namespace roomgen {

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
