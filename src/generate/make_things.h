#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workplace.h"

namespace roomgen {

/// What an item is made into by rules, of these words in place of what it is called; nothing where
/// nobody knows how.
Result<std::optional<AssetInfo>> made_by_rules(const Workplace& place, const PlanItem& item,
                                               const std::string& words, const Vec3& size);

/// Something that a designer made.
struct MadeThing {
  std::optional<AssetInfo> asset;  ///< whose key alone builds it again; nothing: it cannot be used
  std::string fault;               ///< why there is none, or what is wrong with it still
};

/// Lets the designer make what these offers say, all at once, and mend what it then sees; one
/// result for each. What was asked and answered is added to the choices.
std::vector<MadeThing> make_things(Workplace& place, const std::vector<AssetOffer>& offers);

}  // namespace roomgen
