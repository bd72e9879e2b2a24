#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomgen/scene/room.h"

namespace roomgen::brief {

/// Doors, windows or passages of one kind as a prompt asks for them.
struct OpeningWish {
  std::string kind;  ///< of data/openings.json
  OpeningType type = OpeningType::door;
  int count = 1;
  bool counted = false;                 ///< the prompt gives the number
  std::optional<double> width, height;  ///< told, metres
  double wide = 1.0, high = 1.0;        ///< factors on the usual size: "large", "tall"
  /// The sides of the room that are told, as a viewer of the plan has them: 0 front, 1 right, 2
  /// back, 3 left.
  std::vector<int> sides;
  int walls = 0;                        ///< on so many different walls; 0: not said
  std::optional<OpeningType> opposite;  ///< in the wall across from the first of these
  std::optional<OpeningType> beside;    ///< in the same wall as the first of these

  bool has_place() const { return !sides.empty() || walls > 0 || opposite || beside; }
};

}  // namespace roomgen::brief
