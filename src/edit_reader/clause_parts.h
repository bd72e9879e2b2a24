#pragma once

#include <optional>
#include <string>
#include <vector>

#include "destinations.h"
#include "edit_text.h"
#include "references.h"
#include "roomgen/edit/operation.h"

namespace roomgen {

template <typename T>
using MayRead = std::optional<Result<Read<T>>>;  ///< nothing: the words say no such thing

using Ids = std::vector<std::string>;

/// "the vase on the coffee table", "the printer and both plants", "everything on the desk except the lamp".
/// With `with_places` words of place that follow a thing tell which is meant.
MayRead<Ids> things_at(const EditText& text, std::size_t at, bool with_places);

/// "dark oak", "in bottle-green leather": up to the end of the clause, if it means a look. `of_room`: of floors
/// and walls.
bool describes_looks(const std::string& words);
MayRead<std::string> looks_at(const EditText& text, std::size_t at, bool of_room);

/// "a small round table", "taller ones with backs", as the library is asked for it instead of a thing.
struct Substitute {
  std::string category;  ///< empty: another of the same kind
  std::string description;
  std::vector<language::Measure> measures = {};  ///< "a 3 m one"
};
MayRead<Substitute> substitute_at(const EditText& text, std::size_t at);

}  // namespace roomgen
