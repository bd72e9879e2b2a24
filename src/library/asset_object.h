#pragma once

#include <optional>

#include "roomgen/kinds/kind_table.h"
#include "roomgen/library/library.h"

namespace roomgen {

/// The thing of a kind that an asset makes at a size, without a name or a place. `model` is the asset's mesh; may
/// be null.
Object object_of_asset(const AssetInfo& asset, const Kind& kind, const Vec3& size, const Model* model);

/// The size at which an asset is placed: lengths that differ from the kind's `usual` ones come as
/// near to what is wanted as the mesh can be stretched without showing it (SeenAsset::stretch),
/// others of furniture a little nearer. What has no front may stand the other way round.
Vec3 fitted_size(const AssetInfo& asset, const Vec3& usual, const Vec3& wanted);

/// The factors by which a length that was said may be missed: of furniture, and of what is made to measure.
inline constexpr double most_off = 1.25, most_off_measure = 1.05;

/// Is a side so far from the wanted one, whatever is stretched, that nobody would accept it?
bool contradicts_size(const AssetInfo& asset, const Vec3& usual, const Vec3& wanted,
                      double off = most_off);

/// The side that is farther from what was said of it, or is usual, than people accept; null if none is.
std::optional<int> far_off_side(const Vec3& have, const Vec3& usual, const Vec3& wanted,
                                double off = most_off);

/// Is a length another one than the kind's own?
bool is_length_told(double wanted, double usual);

}  // namespace roomgen
