#pragma once

#include <string>
#include <vector>

#include "base/random.h"
#include "brief/room_kinds.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::design {

/// How the things of one room look: one adjective of style, one finish for each group of kinds, so
/// that what stands together goes together.
class Looks {
 public:
  Looks(const RoomKinds& kinds, const KindTable& table, const std::vector<std::string>& styles,
        Random random);

  /// "modern wooden double bed"
  std::string describe(const std::string& category, const std::string& variant) const;

 private:
  const KindTable* table_;
  std::string adjective_;
  std::vector<std::pair<std::vector<std::string>, std::string>> finishes_;  ///< kinds and the word
};

}  // namespace roomgen::design
