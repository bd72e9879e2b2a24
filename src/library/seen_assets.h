#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "attribute_words.h"
#include "roomgen/base/result.h"
#include "roomgen/scene/object.h"

namespace roomgen {

/// How far the sides of a mesh may be scaled before it looks wrong.
struct Stretch {
  std::array<Interval, 3> factors;
  int alike = 0;  ///< so many of the first axes are scaled by one factor
};

struct SeenPart {
  std::string part, color, material;
};

/// What a person who looked at an asset in four views says of it.
struct SeenAsset {
  std::string is;    ///< "white leather sofa with right chaise"
  std::string kind;  ///< as kinds are named
  std::vector<std::string> words, style;
  int formality = 3;            ///< 1 playful to 5 stately
  std::vector<SeenPart> parts;  ///< by surface, the largest first
  Making has;                   ///< what matters for use: "drawer"
  std::string shape;            ///< outline from above: "round", "L-shaped"
  Stretch stretch;
  std::optional<Vec3> true_size;  ///< metres, where the mesh is off
  int looks = 3;                  ///< 1 to 5
  bool is_flawed = false;
  bool front = true;              ///< false: all sides are alike
  std::optional<Mount> mount;
  bool unsteady = false;  ///< does not stand by itself as its mesh is: left out of the catalogue

  /// All words that say what it is and looks like, its main parts included.
  std::vector<std::string> told() const;
};

/// By "library/id".
using SeenAssets = std::map<std::string, SeenAsset>;
Result<SeenAssets> parse_seen_assets(std::string_view text, const std::string& source);
/// data/furniture-seen.json, the one table of what the meshes of known libraries are.
const SeenAssets& seen_assets();
/// Null if nobody looked at it.
const SeenAsset* seen_asset(const AssetRef& asset);

}  // namespace roomgen
