#pragma once

#include "roomgen/kinds/kind_table.h"
#include "roomgen/library/library.h"

namespace roomgen {

/// The thing of a kind that an asset makes at a size, without a name or a place. `model` is the asset's mesh; may
/// be null.
Object object_of_asset(const AssetInfo& asset, const Kind& kind, const Vec3& size, const Model* model);

/// The size at which an asset is placed: width and depth of furniture come as near to what is wanted as a mesh can be
/// stretched without showing it; `asked` lengths that differ from the kind's own, as near as it stays what it is.
Vec3 fitted_size(const AssetInfo& asset, const Kind& kind, Mount mount, const Vec3& wanted, bool asked);

/// Is a length another one than the kind's own?
bool is_length_told(double wanted, double usual);

}  // namespace roomgen
