#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "roomgen/base/json.h"

namespace roomgen {

/// A mesh built by a recipe instead of taken from a library.
struct ProceduralSource {
  std::string recipe;             ///< "mirror"
  nlohmann::ordered_json params;  ///< numbers and texts that the recipe reads, null if none
  std::uint64_t seed = 0;

  bool operator==(const ProceduralSource&) const = default;
};

/// Where the mesh of an object, a door or a window comes from. Empty ids mean a plain box, or the
/// room's own woodwork.
struct AssetRef {
  std::string library;
  std::string id;
  std::string sha256;  ///< of the source file
  std::string license;
  std::string creator;
  std::optional<ProceduralSource> procedural;

  bool is_box() const { return id.empty() && !procedural; }
  bool operator==(const AssetRef&) const = default;
};

/// One string that identifies the geometry: the key of a ModelTable. Empty for a plain box.
std::string asset_key(const AssetRef& asset);

/// The "asset" of scene.json (docs/scene.schema.json).
Json to_json(const AssetRef& asset);
/// Empty if there is none.
AssetRef read_asset(const JsonReader& json);

}  // namespace roomgen
