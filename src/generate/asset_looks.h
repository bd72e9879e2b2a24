#pragma once

#include <string>

#include "roomgen/library/library.h"

namespace roomgen {

/// Is it known of the asset that it is as the word says: by its colours, its name and tags, its
/// outline, or the description that it was built from?
bool looks_like(const AssetInfo& asset, const std::string& word);

}  // namespace roomgen
