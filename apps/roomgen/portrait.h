#pragma once

#include <filesystem>

#include "roomgen/base/result.h"
#include "roomgen/library/library.h"

namespace roomgen::cli {

/// A picture of one asset alone, in a corner of an empty room of fitting size.
Status write_portrait(const AssetInfo& info, std::shared_ptr<const Model> model, int pixels,
                      const std::filesystem::path& path);

}  // namespace roomgen::cli
