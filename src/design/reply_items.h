#pragma once

#include <string>
#include <vector>

#include "brief/kind_mention.h"
#include "brief/room_kinds.h"
#include "plan/inventory.h"
#include "roomgen/base/json.h"

namespace roomgen::design {

/// What the objects of an answer are named after.
struct ItemLexicon {
  const KindTable& table;
  const brief::RoomKind& kind;  ///< of the room: what a "sink" is depends on it
};

/// The canonical category that a name means, else what its description begins with; empty if
/// neither names one.
std::string category_named(const std::string& name, const std::string& description,
                           const ItemLexicon& lexicon);

/// The objects of an answer as drafts; draft i is mention i. What stands on others demands them.
/// Notes what was cut, guessed or left out.
std::vector<plan::Draft> read_reply_items(const Json& objects, const ItemLexicon& lexicon,
                                    std::vector<std::string>& repairs);

}  // namespace roomgen::design
