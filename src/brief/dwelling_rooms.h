#pragma once

#include <string>
#include <vector>

#include "dwelling_names.h"
#include "dwelling_prompt.h"

namespace roomgen::brief {

/// A room that there shall be.
struct FoundRoom {
  std::string type;
  std::size_t owner = SaidRoom::none;  ///< index of the room from which it alone is entered
  std::size_t introduced = 0;          ///< the token behind its name
  std::string adjectives;              ///< "large "
};

/// Indices of those of a type.
std::vector<std::size_t> rooms_of_type(const std::vector<FoundRoom>& rooms,
                                       const std::string& type);

/// Where the dwelling as a whole is named ("a two-bedroom apartment"); null if nowhere.
const NamedRoom* whole_dwelling(const DwellingText& text, const std::vector<NamedRoom>& names);

/// The rooms that names introduce, and those that such a dwelling has besides; none if the prompt
/// is about no dwelling. Tells the names which rooms they mean.
std::vector<FoundRoom> find_rooms(const DwellingText& text, std::vector<NamedRoom>& names,
                                  std::vector<std::string>& notes);

}  // namespace roomgen::brief
