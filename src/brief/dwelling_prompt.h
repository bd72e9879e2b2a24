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

/// A room of a dwelling and what the prompt says of it.
struct SaidRoom {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::string type;          ///< "bedroom"
  std::size_t owner = none;  ///< index of the room from which it alone is entered (en suite)
  Brief brief;  ///< of its own words; their spans are of the whole prompt, empty where only meant
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
/// said of, one that names no room to the room where its things usually stand. Nothing is concluded.
std::optional<SaidDwelling> read_dwelling(std::string_view prompt, const DwellingKinds& dwellings,
                                          const RoomKinds& kinds, const KindTable& table);

}  // namespace roomgen::brief
