#pragma once

#include "roomgen/kinds/kind_table.h"
#include "roomgen/library/library.h"

namespace roomgen {

/// The thing of a kind that an asset makes at a size, without a name or a place. `model` is the asset's mesh; may
/// be null.
Object object_of_asset(const AssetInfo& asset, const Kind& kind, const Vec3& size, const Model* model);

}  // namespace roomgen
