#pragma once

#include "clause_parts.h"

namespace roomgen {

/// Places of which each takes one thing, or one lot of things: "at either end of the table", "on every desk", "one in
/// each corner", with what each has for relations. `is_small`: what goes there stands on other things.
struct SharedPlaces {
  std::vector<std::vector<Relation>> places;
  bool flanks = false;  ///< both sides of one thing
  bool each = false;    ///< as many on each of them: "two on each side"
};
MayRead<SharedPlaces> shared_places_at(const EditText& text, std::size_t at, bool is_small);

}  // namespace roomgen
