#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "brief.h"
#include "room_kinds.h"
#include "roomgen/base/json.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::brief {

/// brief.json (docs/brief.schema.json): what is read in a wish, clause by clause, before anything
/// is concluded from it (conclude(), prompt.h). How rules are to take it stands in members called
/// "rules".
Json to_json(const Brief& brief, std::string_view prompt);

/// A brief as somebody else wrote it.
struct BriefReading {
  Brief brief;
  std::vector<std::string> problems =
      {};  ///< where and what is wrong: "/things/2/relations/0: …"; the rest was read
  std::vector<std::string> repairs = {};  ///< what was understood otherwise than it was written
};

/// Reads such a form of a model as far as it goes; how rules took a wish is not read back.
/// `pointer`: of the form in its document, for messages. Words are looked up in the wish as they
/// are quoted there; what the wish does not say is left out.
BriefReading brief_from_json(const Json& json, std::string_view prompt, const RoomKinds& kinds,
                             const KindTable& table, const std::string& pointer = "");

}  // namespace roomgen::brief
