#pragma once

#include <string>
#include <vector>

#include "roomgen/library/library.h"
#include "roomgen/scene/plan.h"

namespace roomgen {

/// A thing whose shape program somebody wrote.
struct WrittenThing {
  AssetInfo asset;                 ///< whose key alone builds it again
  std::vector<std::string> notes;  ///< what is not as it was asked for, or was not clear
  std::string fault;               ///< what is clearly wrong with it, though it can be used
};

/// As an asset for the item: by its name, words, size and mount. `library` builds programs.
Result<WrittenThing> written_thing(const AssetLibrary& library, const std::string& program,
                                   const PlanItem& item, std::uint64_t seed);

}  // namespace roomgen
