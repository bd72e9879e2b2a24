#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "prompt_words.h"
#include "room_kinds.h"
#include "roomgen/base/result.h"

namespace roomgen::brief {

/// What a kind of room is in a dwelling.
struct DwellingRoom {
  int hub = 0;                         ///< how well it gives access to others; 0: not at all
  bool night = false;                  ///< lies with bedrooms rather than with the living room
  Range area{9.0, 14.0};               ///< square metres
  std::vector<std::string> passage;    ///< rooms from which it is entered without a door between
  std::vector<std::string> owns;       ///< rooms that may be entered from it alone (en suite)
};

/// data/dwellings.json (docs/dwellings.md).
struct DwellingKinds {
  std::map<std::string, std::vector<std::string>, std::less<>> dwellings;  ///< usual rooms, by noun
  std::vector<std::string> never_without;  ///< rooms that no dwelling lacks, whatever is named of it
  std::map<std::string, int, std::less<>> links;  ///< phrases after which a further room is named
  WordSet no_rooms;                               ///< names of rooms that are parts of others
  std::map<std::string, DwellingRoom, std::less<>> rooms;
};

Result<DwellingKinds> parse_dwelling_kinds(std::string_view text, const std::string& source);
/// The knowledge compiled into the library.
const Result<DwellingKinds>& built_in_dwelling_kinds();

}  // namespace roomgen::brief
