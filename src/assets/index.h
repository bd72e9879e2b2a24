#pragma once

#include <filesystem>
#include <string>

#include "asset_source.h"
#include "decode/decoder.h"
#include "library/seen_assets.h"
#include "library/vocabulary.h"
#include "roomgen/assets/catalogue.h"
#include "roomgen/base/result.h"

namespace roomgen::assets {

/// The catalogue file of one library, made now unless the one in the cache folder still holds: same
/// file or folder content by size and time, same knowledge, vocabulary and format. Built aside and
/// renamed, so that a process reading the old one keeps it and two that build at once do no harm.
Result<std::filesystem::path> ensure_index(const std::filesystem::path& library,
                                           const CatalogueOptions& options);

/// How the options want meshes to be read.
decode::DecoderOptions decoder_options(const CatalogueOptions& options);

/// What an asset is and how it is put up: category, mount, front, roundness, support height. What
/// somebody saw goes before what the library states, that before what the vocabulary knows of the
/// kind, and that before a guess from size and elevation. Precondition: `asset.info.size` is known.
AssetInfo classify(const SourceAsset& asset, const SeenAsset* seen, const Vocabulary& vocabulary);

/// Where the catalogue of a library is kept: a file of its own for each library and for each state of what
/// this program knows of furniture, so that two versions of the program do not take it from each other.
std::filesystem::path catalogue_path(const std::filesystem::path& library, const std::filesystem::path& cache_dir);

/// What a catalogue is made from: changes when a file of the library does, or what this program knows.
Result<std::string> stamp_of(const std::filesystem::path& library);

/// Writes a hash of the catalogue beside it, which tells later whether its bytes are still those that were
/// written.
Status seal(const std::filesystem::path& catalogue);
bool is_sealed(const std::filesystem::path& catalogue);
bool is_whole(const std::filesystem::path& catalogue);

/// Removes catalogues of the same library that other versions made, but for the newest few.
void drop_older(const std::filesystem::path& catalogue);

}  // namespace roomgen::assets
