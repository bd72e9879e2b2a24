#pragma once

#include <string>
#include <vector>

#include "book.h"
#include "brief/brief.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::book {

/// How well a design serves a wish.
struct Candidate {
  const Design* design = nullptr;
  Values values;  ///< set by the wish
  double score = 0.0;
  double things = 0.0;      ///< asked for that it has
  bool is_of_kind = false;  ///< it is a design of the room that the wish names
  std::string why;          ///< the terms of the score, for people
};

/// What a wish says that designs are chosen by.
struct Wanted {
  const brief::Brief& brief;
  std::string type;          ///< of the room: "living room"
  std::optional<Vec2> size;  ///< that it shall have, metres
};

/// Sets the parameters by the wish: people, numbers of things; and what it leaves open by the size.
Values values_for(const Design& design, const Wanted& wanted, const KindTable& kinds);

/// All designs, best first.
std::vector<Candidate> candidates(const std::vector<const Design*>& designs, const Wanted& wanted,
                                  const KindTable& kinds);

}  // namespace roomgen::book
