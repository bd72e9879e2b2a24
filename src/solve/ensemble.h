#pragma once

#include <span>
#include <vector>

#include "collision/occupancy_grid.h"
#include "movable.h"
#include "rug_rule.h"

namespace roomgen {

/// A whole layout whose things are put elsewhere all the time: the same rules as Layout's, for all things at
/// once, and without copies.
class Ensemble {
 public:
  /// The layout must outlive this. It holds all of the things, wherever they stand, whenever something is asked.
  Ensemble(Layout& layout, std::span<const Movable> movables, RugRule rugs);

  std::size_t size() const { return things_.size(); }
  const Footprint& footprint(std::size_t i) const { return things_[i].footprint; }
  double base(std::size_t i) const { return bottom(objects_[i]); }
  Pose pose(std::size_t i) const;

  /// Puts a thing elsewhere, as files hold it. Nothing is tested.
  void put(std::size_t i, const Pose& pose);

  /// Do all its constraints hold where things stand now?
  bool holds(std::size_t i);
  bool fits_room(std::size_t i) const;
  /// Or do the two stand to each other as a rug and a thing must not?
  bool collides(std::size_t i, std::size_t other) const;
  /// The rest, after some things were put elsewhere: meshes, and everybody's use zones and the doors stay
  /// reachable.
  bool is_sound(std::span<const std::size_t> moved);

 private:
  struct Stamp {
    bool there = false;
    Footprint footprint;
  };
  bool solids_apart(std::span<const std::size_t> moved);
  void bring_occupancy_up_to_date();
  const ResolvedRelation& resolved(BoundRelation& bound) const;

  Layout& layout_;
  RugRule rugs_;
  std::vector<Object> objects_;
  std::vector<FloorThing> things_;
  std::vector<Layout::Candidate> candidates_;
  std::vector<FootprintAt> footprint_at_;
  std::vector<std::vector<BoundRelation>> relations_;
  OccupancyGrid occupancy_;
  std::vector<Stamp> stamps_;  ///< what of the things the occupancy knows
};

}  // namespace roomgen
