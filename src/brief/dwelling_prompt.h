#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brief.h"
#include "dwelling_kinds.h"
#include "room_kinds.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::brief {

/// Bytes of a room's own prompt that stand for bytes of the whole prompt.
struct Origin {
  language::Span own, whole;
};

/// A room of a dwelling and what the prompt says of it.
struct SaidRoom {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::string type;             ///< "bedroom"
  std::string prompt;           ///< a prompt for this room alone
  std::optional<Brief> brief = {};  ///< what it says, where that is read already; then the prompt is the whole one
  std::vector<Origin> origins;  ///< of its words, in their order
  std::size_t owner = none;     ///< index of the room from which it alone is entered (en suite)
};

struct SaidDwelling {
  std::vector<SaidRoom> rooms;
  std::optional<double> area;      ///< of all rooms, square metres
  std::vector<std::string> notes;
  std::vector<HeardWords> heard;  ///< what names the dwelling and its rooms
  std::vector<language::Token> tokens;  ///< of the whole prompt
};

/// The rooms of a prompt that asks for several ("a two-bedroom apartment", "a bedroom with an
/// en-suite bathroom"); nothing if it is about one room. Each clause goes to the room that it is
/// said of, one that names no room to the room where its things usually stand.
std::optional<SaidDwelling> read_dwelling(std::string_view prompt, const DwellingKinds& dwellings,
                                          const RoomKinds& kinds, const KindTable& table);

}  // namespace roomgen::brief
