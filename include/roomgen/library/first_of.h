#pragma once

#include <memory>
#include <vector>

#include "roomgen/library/library.h"

namespace roomgen {

/// Several libraries as one: a search asks them in order and takes the answers of the first that
/// has any that does not contradict the query, so that a catalogue of real furniture goes before one
/// that builds what is asked for, and what is built before what looks otherwise than asked. Matches that
/// contradict are answers when there are no others. A failing search is an error; load() asks the libraries in order until one knows the asset.
std::unique_ptr<AssetLibrary> make_first_of(
    std::vector<std::shared_ptr<const AssetLibrary>> libraries);

}  // namespace roomgen
