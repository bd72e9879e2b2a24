#pragma once

#include <string>
#include <vector>

#include "base/json_reader.h"
#include "roomgen/base/json.h"
#include "roomgen/geometry/polygon.h"
#include "roomgen/scene/relation.h"

namespace roomgen {

/// The walls as a file counts them. Rooms are kept counter-clockwise and without needless corners, so
/// "wall-2" of a file may be another wall of the room.
class FileWalls {
 public:
  /// `corners` as the file has them, `polygon` as the room keeps them.
  FileWalls(const std::vector<Vec2>& corners, const Polygon& polygon);

  /// Renames the walls that the relations name to those of the room.
  void rename(std::vector<Relation>& relations) const;
  /// "wall-2" as the room counts; other names stay.
  void rename(std::string& wall) const;

 private:
  std::vector<std::size_t> wall_of_;  ///< by the file's number
};

/// The corners of a polygon in a file, at most 500; reports what is wrong with them.
std::vector<Vec2> read_corners(const JsonReader& json);

}  // namespace roomgen
