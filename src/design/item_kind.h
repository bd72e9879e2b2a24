#pragma once

#include <optional>
#include <string>

#include "brief/room_kinds.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::design {

/// What the objects of an answer are named after.
struct ItemLexicon {
  const KindTable& table;
  const brief::RoomKind& kind;  ///< of the room: what a "sink" is depends on it
};

/// A thing as an answer tells of it.
struct SaidThing {
  std::string name;
  std::string description = {};
  std::optional<Vec3> size = std::nullopt;  ///< metres
  std::optional<Mount> mount = std::nullopt;
};

/// The kind of a thing: the one that its whole name or an ending of it names, if things of that
/// kind are about as large and as special as what is told; else the thing is a kind of its own,
/// under a name that means no other kind ("scent-organ"). Empty if neither name nor description
/// says what it is.
std::string kind_of(const SaidThing& thing, const ItemLexicon& lexicon);

/// "Bed_1" is a bed.
std::string plain_name(const std::string& name);

}  // namespace roomgen::design
