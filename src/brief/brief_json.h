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

/// Where a form comes from. A model says what it read, and how rules take it is found here; what
/// roomgen wrote itself is taken as it is.
enum class FormAuthor { model, roomgen };
struct FormSource {
  FormAuthor author = FormAuthor::model;
  std::string pointer = {};  ///< of the form in its document, for messages
};

/// Reads such a form as far as it goes. Words are looked up in the wish as they are quoted there;
/// what the wish does not say is left out.
BriefReading brief_from_json(const Json& json, std::string_view prompt, const RoomKinds& kinds,
                             const KindTable& table, const FormSource& source = {});

}  // namespace roomgen::brief
