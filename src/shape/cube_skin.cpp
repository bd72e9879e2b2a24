#include "cube_skin.h"

#include <Eigen/Geometry>

namespace roomgen::shape {

namespace {

// A face with its directions as seen from outside; right x up = out.
struct CubeFace {
  Vec3 out, right, up;
};
const CubeFace cube_faces[] = {{-Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitZ()},
                               {Vec3::UnitY(), -Vec3::UnitX(), Vec3::UnitZ()},
                               {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()},
                               {-Vec3::UnitX(), -Vec3::UnitY(), Vec3::UnitZ()},
                               {Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY()},
                               {-Vec3::UnitZ(), Vec3::UnitX(), -Vec3::UnitY()}};

using Grid = std::vector<std::vector<Corner>>;

// Lengths along the grid's middle lines serve as coordinates of the whole face.
void set_uvs(Grid& grid) {
  const std::size_t n = grid.size(), middle = n / 2;
  std::vector<double> right(n, 0.0), up(n, 0.0);
  for (std::size_t k = 1; k < n; ++k) {
    right[k] = right[k - 1] + (grid[middle][k].position - grid[middle][k - 1].position).norm();
    up[k] = up[k - 1] + (grid[k][middle].position - grid[k - 1][middle].position).norm();
  }
  const bool upright = up.back() > right.back() * (1.0 + 1e-9);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) grid[j][i].uv = surface_uv(right[i], up[j], upright);
}

}  // namespace

void add_cube_skin(SurfaceBuilder& surface, const std::vector<Tick>& ticks,
                   const std::function<Corner(const Vec3& at, const Vec3& side)>& place) {
  const std::size_t n = ticks.size();
  int group = 0;
  for (const auto& face : cube_faces) {
    Grid grid(n, std::vector<Corner>(n));
    // The ticks are symmetric to the last bit: a direction that runs backwards only changes signs.
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        grid[j][i] = place(face.out + ticks[i].at * face.right + ticks[j].at * face.up,
                           face.out + ticks[i].side * face.right + ticks[j].side * face.up);
    for (auto& row : grid)
      for (auto& corner : row) corner.group = group;
    set_uvs(grid);
    for (std::size_t j = 0; j + 1 < n; ++j)
      for (std::size_t i = 0; i + 1 < n; ++i)
        surface.quad(grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]);
    ++group;
  }
}

}  // namespace roomgen::shape
