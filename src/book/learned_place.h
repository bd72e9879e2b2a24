#pragma once

#include <array>

#include "learned_unit.h"
#include "roomgen/base/json.h"
#include "scene/wall_sides.h"
#include "seen_opening.h"

namespace roomgen::book {

/// A coordinate that follows the size of the room: a share of its width or depth, and metres.
struct Along {
  double share = 0.0, offset = 0.0;

  double at(double length) const { return share * length + offset; }
};

/// A number or formula: "W - 1.2". `side` is "W" or "D"; `more` is added to it.
Json told(const Along& along, const char* side, const std::string& more = "");

/// Of a length with something from `low` to `high` in it and its middle at `middle`: what is near
/// an end keeps its distance to that, else the ends keep their shares of what is left.
Along along_of(double low, double high, double middle, double length);

using Place2 = std::array<Along, 2>;
/// Where the units are, so that those that stand near each other stay so.
std::vector<Place2> places_of(const std::vector<Unit>& units, const Vec2& size);

/// The side of the compass to which a front looks; nothing: between two.
std::optional<int> side_faced(double yaw);

/// The "stands" of a unit in a room whose box begins at 0, 0. `numbers` are the grid's rows and
/// columns as formulas, which the place of the first copy follows.
struct Surroundings {
  const Room& room;
  std::vector<SeenOpening> openings;
};
Json told_stands(const Unit& unit, const Place2& place, const Surroundings& around,
                 const std::array<std::string, 2>& numbers);

}  // namespace roomgen::book
