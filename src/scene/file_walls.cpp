#include "file_walls.h"

#include <nlohmann/json.hpp>

#include "file_limits.h"

namespace roomgen {

namespace {

constexpr std::size_t max_corners = 500;

}  // namespace

FileWalls::FileWalls(const std::vector<Vec2>& corners, const Polygon& polygon) {
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 middle = 0.5 * (corners[k] + corners[(k + 1) % corners.size()]);
    std::size_t wall = k;
    for (std::size_t i = 0; i < polygon.size(); ++i)
      if (distance(polygon.edge(i), middle) < 1e-6) wall = i;
    wall_of_.push_back(wall);
  }
}

void FileWalls::rename(std::vector<Relation>& relations) const {
  for (auto& relation : relations) rename(relation.target);
}

void FileWalls::rename(std::string& wall) const {
  for (std::size_t k = 0; k < wall_of_.size(); ++k)
    if (wall == "wall-" + std::to_string(k)) {
      wall = "wall-" + std::to_string(wall_of_[k]);
      break;
    }
}

std::vector<Vec2> read_corners(const JsonReader& json) {
  std::vector<Vec2> corners;
  for (const auto& element : json.elements(max_corners)) {
    const auto corner = element.numbers(2, -max_coordinate, max_coordinate);
    corners.push_back({corner[0], corner[1]});
  }
  return corners;
}

}  // namespace roomgen
