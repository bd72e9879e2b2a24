#pragma once

#include "root_folder.h"
#include "roomgen/base/json.h"

/// Rooms as resources: roomgen:///bedroom/scene.json and roomgen:///bedroom/ledger.json.
namespace roomgen::mcp {

/// Both of every room below the root.
Json list_resources(const RootFolder& root);
/// not_found for an address that is none of these.
Result<std::string> read_resource(const RootFolder& root, const std::string& uri);

/// A path in an address: what may not stand there as %20. And back; not_found for a broken one.
std::string percent_encoded(const std::string& path);
Result<std::string> percent_decoded(const std::string& text);

}  // namespace roomgen::mcp
