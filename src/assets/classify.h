#pragma once

#include "asset_source.h"
#include "library/seen_assets.h"
#include "library/vocabulary.h"

namespace roomgen::assets {

/// What an asset is and how it is put up: category, mount, front, roundness, support height. What
/// somebody saw goes before what the library states, that before what the vocabulary knows of the
/// kind, and that before a guess from size and elevation. Precondition: `asset.info.size` is known.
AssetInfo classify(const SourceAsset& asset, const SeenAsset* seen, const Vocabulary& vocabulary);

}  // namespace roomgen::assets
