#pragma once

#include <string>
#include <vector>

#include "dwelling_text.h"

namespace roomgen::brief {

/// A room, or the dwelling as a whole, where the prompt names it.
struct NamedRoom {
  std::size_t begin = 0;  ///< of its phrase: "two large bedrooms"
  std::size_t noun = 0, end = 0;
  std::string type;       ///< empty: the dwelling
  int count = 1;
  bool numbered = false;  ///< "two", "a"
  bool definite = false;  ///< "the bedroom"
  bool every = false;     ///< "both bedrooms", "each bedroom"
  bool en_suite = false;
  std::size_t ordinal = 0;  ///< "the second bedroom": 1
  std::vector<std::size_t> rooms;  ///< that it means (find_rooms())
};

/// In the order of the prompt.
std::vector<NamedRoom> find_room_names(const DwellingText& text);

}  // namespace roomgen::brief
