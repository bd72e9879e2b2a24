#pragma once

#include "clause.h"

namespace roomgen {

/// "a gap of 5 cm from the nightstand to the bed", "60 cm of free space to the wardrobe": a distance that shall be
/// left between things. `subjects` are what the clause is about, none where the words name both.
struct KeptGap {
  double metres = 0.0;
  Ids first;           ///< that moves
  std::string second;  ///< a thing, a wall or an opening
};
MayRead<KeptGap> gap_at(const EditText& text, std::size_t at, const Ids& subjects);

/// Moves the first ones straight to or from the second until that is left between them.
ReadClause keep_gap(const EditText& text, const Read<KeptGap>& gap);

}  // namespace roomgen
