#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/random.h"
#include "brief/opening_wish.h"
#include "brief/room_kinds.h"
#include "scene/opening_kind.h"
#include "wall_stretch.h"

namespace roomgen::plan {

/// An opening that looks for its place: what it is, how wide it would like to be, and where it would like
/// to stand.
struct OpeningNeed {
  Opening opening;  ///< at the beginning of its wall; that says nothing of where it goes
  double least = least_window;  ///< width; a narrower one is left out
  double clear = least_gap;     ///< of wall on either side, where it has a stretch to itself
  /// It becomes narrower before it looks for another wall.
  bool yields = false;
  /// Somebody asked for it: it rather becomes narrower than leave its wall, a window rather shares a wall
  /// than be left out, and what becomes of it is noted.
  bool asked = false;
  std::vector<std::size_t> walls;  ///< told, by preference; empty: any
  std::optional<OpeningType> opposite, beside;
  /// Where its middle would like to be in a stretch of its own, from 0, the beginning, to 1; the first of
  /// those that are least in the way is taken. Empty: at one of the ends, drawn, if it likes corners, else
  /// in the middle.
  std::vector<double> middles;
  double likes_length = 0.5;  ///< against one opening more in a wall, 10; negative: short stretches are best

  bool is_window() const { return opening.type == OpeningType::window; }
  /// Doors stand beside the wall at which they open; wide ones do not.
  bool likes_corner() const;
};

/// A plain door.
OpeningNeed plain_door(double width, double least, double ceiling);
/// The door of a kind of room.
OpeningNeed usual_door(const brief::RoomKind& kind, double ceiling);
/// A window of the kind's heights; its width is drawn.
OpeningNeed usual_window(const brief::RoomKind& kind, bool wide, double ceiling, Random& random);
/// The whole of a bay's wall.
OpeningNeed glazing(const brief::RoomKind& kind, double width, double ceiling);
/// What a prompt asks for, of a kind of data/openings.json; its place is not yet told.
OpeningNeed wished_opening(const brief::OpeningWish& wish, const OpeningKind& kind,
                           const brief::RoomKind& room, double ceiling, Random& random);

/// Lets a door become as narrow as the longest of the stretches demands, rather than have no door.
void squeeze(OpeningNeed& door, std::span<const WallStretch> stretches);

}  // namespace roomgen::plan
