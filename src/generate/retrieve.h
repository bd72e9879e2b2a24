#pragma once

#include <map>
#include <string>
#include <vector>

#include "roomgen/base/random.h"
#include "roomgen/library/library.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/plan.h"

namespace roomgen {

/// Chooses the assets to try for planned objects. Objects that are asked for in the same words share
/// their asset unless the item asks for variety; among assets that fit about equally well the seed decides.
class Retriever {
 public:
  /// All must outlive this.
  Retriever(const AssetLibrary& library, const KindTable& categories, std::uint64_t seed)
      : library_(library), categories_(categories), random_(seed) {}

  /// The best few, in the order in which they shall be tried; empty if nothing fits.
  Result<std::vector<AssetInfo>> candidates(const PlanItem& item, const PlannedObject& planned,
                                            int count);
  /// Others of the same words take what this one took.
  void remember(const PlanItem& item, const AssetInfo& asset);

 private:
  const AssetLibrary& library_;
  const KindTable& categories_;
  Random random_;
  std::map<std::string, AssetInfo> chosen_;  ///< by what was asked for
};

}  // namespace roomgen
