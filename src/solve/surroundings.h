#pragma once

#include <vector>

#include "geometry/inside.h"
#include "layout.h"
#include "roomgen/scene/problem.h"
#include "scene/judgement.h"
#include "seats.h"

namespace roomgen {

/// What around a thing matters to how its kind prefers to stand: gathered once, asked for many poses.
struct Surroundings {
  /// Another thing. Those of the thing's own relations are its partners.
  struct Neighbour {
    Footprint footprint;
    double top = 0.0;
    bool flat = false;
    bool on_floor = false;
    bool like = false;     ///< of the thing's own kind
    bool partner = false;
  };
  /// Floor that a neighbour wants open, as points of it.
  struct Reserve {
    Bounds2 bounds;
    std::vector<Vec2> points;
  };

  /// One of the thing's own relations, as far as it is a matter of degree.
  struct Wish {
    ResolvedRelation relation;
    bool asked = false;
  };

  /// `company` share the seats of a table.
  Surroundings(const Layout& layout, const PlacementTask& task, const Arrangement& arrangement,
               int company);

  const Room& room;
  Inside inside;  ///< the room's polygon
  const Object& object;
  const Arrangement& arrangement;
  const Weights& weights;
  Vec2 middle = Vec2::Zero();  ///< of the room's box
  double span = 0.0;           ///< its diagonal
  std::vector<Footprint> doors, windows;
  std::vector<Footprint> door_areas;
  std::vector<Neighbour> neighbours;    ///< all that stand on no other thing
  std::vector<Segment> sight_lines;     ///< from seats to what is watched from them
  std::vector<Reserve> reserves;        ///< of neighbours that are no partners
  std::vector<Footprint> zones_in_use;  ///< in which the thing must not stand
  std::vector<Wish> wishes;
  bool may_be_square = false;       ///< its kind says nothing of being parallel to the walls (Weights::squareness)
  std::vector<SeatPlace> seats;     ///< for a seat, at the tables that it is to stand around
  std::vector<Footprint> beneath;   ///< for a rug, where its groups want it
};

/// How much a place has of what a thing may prefer, in [0, 1].
double degree(const Surroundings& around, const Footprint& footprint, double bottom,
              Preference preference);

/// All that the kind's arrangement says of the place, each by its weight (Weights).
double preference(const Surroundings& around, const Footprint& footprint, double bottom);

/// Share in [0, 1] of the floor around a thing that its use will want and that is still open.
double reserve_open(const Surroundings& around, const Footprint& footprint);
/// Sum over the other things of the shares of their reserves that the thing would take there.
double reserves_taken(const Surroundings& around, const Footprint& footprint);
/// Does a thing of its kind already stand on the same side of one of its partners?
bool is_on_crowded_side(const Surroundings& around, const Footprint& footprint);

/// Where the middle of a rug lies that belongs to the target.
Vec2 middle_beneath(const Arrangement& rug, const Kind& kind, const Footprint& target);

}  // namespace roomgen
