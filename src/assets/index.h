#pragma once

#include <filesystem>

#include "decode/decoder.h"
#include "roomgen/assets/catalogue.h"

namespace roomgen::assets {

/// The catalogue file of one library, made now unless the one in the cache folder still holds: same
/// file or folder content by size and time, same knowledge, vocabulary and format. Built aside and
/// renamed, so that a process reading the old one keeps it and two that build at once do no harm.
Result<std::filesystem::path> ensure_index(const std::filesystem::path& library,
                                           const CatalogueOptions& options);

/// How the options want meshes to be read.
decode::DecoderOptions decoder_options(const CatalogueOptions& options);

}  // namespace roomgen::assets
