#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/random.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/library/library.h"
#include "roomgen/scene/plan.h"

namespace roomgen {

/// What objects took, by the words in which they were asked for: others of the same words take it too, so
/// that what is asked for in the same words looks the same, unless an item asks for variety.
using Favourites = std::map<std::string, AssetInfo>;

/// Where objects look for their assets.
struct AssetSearch {
  const AssetLibrary& library;
  const KindTable& categories;
  std::uint64_t seed = 0;  ///< decides among assets that fit about equally well
};

/// The best few assets for an object, in the order in which they shall be tried: the one that its
/// item names, else what others of the same words took, then the library's. Empty if nothing fits.
Result<std::vector<AssetInfo>> retrieve(const AssetSearch& search, const Favourites& favourites,
                                        const PlanItem& item, const PlannedObject& planned,
                                        int count);

/// What others of the same words took; null if nothing.
const AssetInfo* favourite(const Favourites& favourites, const PlanItem& item);

/// The first asset of each words becomes their favourite.
void remember(Favourites& favourites, const PlanItem& item, const AssetInfo& asset);

}  // namespace roomgen
