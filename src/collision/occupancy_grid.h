#pragma once

#include <cstdint>
#include <vector>

#include "roomgen/geometry/polygon.h"
#include "roomgen/scene/room.h"

namespace roomgen {

/// The person of docs/constraints.md: a disc of 0.5 m.
inline constexpr double person_radius = 0.25;

/// Where a person can stand and walk in a room: a grid over the floor whose cells count the things that
/// keep a disc away from their centre. Adding and removing a thing touches only its surroundings; rows are
/// flooded 64 cells at a time.
class OccupancyGrid {
 public:
  /// A grid of `pitch` metres; walls block what is nearer than the disc's radius.
  explicit OccupancyGrid(const Room& room, double pitch = 0.05);

  void add(const Footprint& footprint) { stamp(footprint, +1); }
  void remove(const Footprint& footprint) { stamp(footprint, -1); }

  /// Walks from the clearance of the first door (a room without doors: from everywhere).
  void flood();
  /// After flood(): is every door connected to the first?
  bool doors_connected() const;
  /// After flood(): can the disc, standing somewhere it can walk to, touch the zone?
  bool reaches(const Footprint& zone) const;

 private:
  struct Cell {
    int column;
    int row;
  };
  int column(double x) const;
  int row(double y) const;
  Vec2 center(int column, int row) const;
  void open_inside(const Polygon& polygon, int row);
  void block_along(const Segment& wall);
  void stamp(const Footprint& footprint, int change);
  void change_count(int column, int row, int change);
  std::vector<Cell> cells_in(const Footprint& area) const;
  bool is_free(int column, int row) const;
  bool is_reachable(int column, int row) const;
  bool flood_row(int row, int from_row);

  double pitch_;
  Vec2 low_;
  int columns_ = 0;
  int rows_ = 0;
  int words_ = 0;                          ///< of 64 cells, per row
  std::vector<std::uint16_t> blocked_;     ///< number of things in the way; walls count one
  std::vector<std::uint64_t> free_;        ///< bit set where nothing blocks
  std::vector<std::uint64_t> reachable_;
  std::vector<std::vector<Cell>> doors_;   ///< cells in the clearance of each entrance
};

}  // namespace roomgen
