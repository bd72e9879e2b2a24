#pragma once

#include <optional>

#include "workplace.h"

namespace roomgen {

/// Something that was made from words.
struct MadeAsset {
  std::optional<AssetInfo> asset;  ///< nothing: nobody knows how
  std::vector<std::string> notes;
};

/// Makes a thing of these words in place of what an item is called: by BuildOptions::maker, else,
/// or where that fails, by rules.
Result<MadeAsset> make_asset(Workplace& place, const PlanItem& item, const std::string& words,
                             const Vec3& size);

}  // namespace roomgen
