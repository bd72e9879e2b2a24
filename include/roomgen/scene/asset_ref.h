#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "roomgen/base/json_fwd.h"

namespace roomgen {

/// A mesh built by a recipe instead of taken from a library.
struct ProceduralSource {
  std::string recipe;  ///< "mirror"
  std::string params;  ///< what the recipe reads, as compact JSON; empty if nothing
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

/// A text among the parameters; empty if there is none of this name.
std::string text_parameter(const ProceduralSource& source, std::string_view name);

/// One string that identifies the geometry: the key of a ModelTable. Empty for a plain box.
std::string asset_key(const AssetRef& asset);

/// The "asset" of scene.json (docs/scene.schema.json).
Json to_json(const AssetRef& asset);
/// Empty if there is none.
AssetRef read_asset(const JsonReader& json);

}  // namespace roomgen
