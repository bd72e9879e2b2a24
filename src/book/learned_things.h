#pragma once

#include <functional>

#include "learned_unit.h"
#include "roomgen/base/json.h"

namespace roomgen::book {

/// How things are told.
struct Telling {
  const KindTable& kinds;
  std::function<std::string(std::string)>
      worded;  ///< puts the palette's roles in place of its words
  bool keep_assets = false;
};

/// A thing as the "objects" of a design have it: what it is, and how large. Without its place.
Json told_thing(const Object& object, const Telling& telling);

/// The "things" of a group: the anchor, what stands with it by a word where one fits ("around
/// table"), else at its place in the anchor's frame, and what stands on them.
Json told_things(const Unit& unit, const Telling& telling);

}  // namespace roomgen::book
