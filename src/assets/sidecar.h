#pragma once

#include <string>

#include "asset_source.h"

namespace roomgen::assets {

/// Applies the JSON beside a mesh (docs/assets.md, docs/asset.schema.json) to `asset`. `source`
/// names the file in errors.
Status apply_sidecar(const std::string& text, const std::string& source, SourceAsset& asset);

}  // namespace roomgen::assets
