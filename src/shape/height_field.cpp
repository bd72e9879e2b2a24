#include <algorithm>
#include <cmath>

#include "checks.h"
#include "roomgen/shape/primitives.h"
#include "skin.h"

namespace roomgen::shape {

namespace {

using Heights = std::vector<std::vector<Vec3>>;

Result<Heights> sampled_grid(const HeightField& solid) {
  const double cell = solid.size.maxCoeff() / solid.divisions;
  const auto count = [&](double length) {
    return std::max<std::size_t>(2, static_cast<std::size_t>(std::lround(length / cell)));
  };
  const std::size_t columns = count(solid.size.x()), rows = count(solid.size.y());
  Heights grid(rows + 1, std::vector<Vec3>(columns + 1));
  for (std::size_t j = 0; j <= rows; ++j)
    for (std::size_t i = 0; i <= columns; ++i) {
      const double u = 2.0 * static_cast<double>(i) / static_cast<double>(columns) - 1.0;
      const double v = 2.0 * static_cast<double>(j) / static_cast<double>(rows) - 1.0;
      const double z = solid.height(u, v);
      if (!std::isfinite(z)) return input_error("height field: a height is not a finite number");
      grid[j][i] = {0.5 * u * solid.size.x(), 0.5 * v * solid.size.y(),
                    std::clamp(z, solid.least, solid.most)};
    }
  return grid;
}

// A wall below a border of the surface that runs from left to right as seen from outside.
void add_wall(SurfaceBuilder& surface, const std::vector<Vec3>& border, const Vec3& normal) {
  Loop loop;
  std::vector<Vec3> points;
  const Vec3& start = border.front();
  const auto add = [&](const Vec3& p) {
    loop.push_back({(p - start).head<2>().norm(), p.z()});
    points.push_back(p);
  };
  add({start.x(), start.y(), 0.0});
  add({border.back().x(), border.back().y(), 0.0});
  for (auto p = border.rbegin(); p != border.rend(); ++p) add(*p);
  add_cap(surface, {loop}, points, normal);
}

std::vector<Vec3> column(const Heights& grid, std::size_t i) {
  std::vector<Vec3> result;
  for (const auto& row : grid) result.push_back(row[i]);
  return result;
}

std::vector<Vec3> backwards(std::vector<Vec3> points) {
  std::reverse(points.begin(), points.end());
  return points;
}

}  // namespace

Result<Mesh> mesh(const HeightField& solid, double tolerance) {
  if (auto s = check_tolerance(tolerance); !s) return s.error();
  if (auto s =
          check_sizes("height field", {solid.size.x(), solid.size.y(), solid.least, solid.most});
      !s)
    return s.error();
  if (solid.least > solid.most)
    return input_error("height field: the least height is above the greatest");
  if (!solid.height) return input_error("height field: has no height");
  if (solid.divisions < 2 || solid.divisions > 128)
    return input_error("height field: the divisions must be between 2 and 128");
  const auto grid = sampled_grid(solid);
  if (!grid) return grid.error();

  SurfaceBuilder surface;
  Skin top;
  top.rows = *grid;
  top.columns_closed = false;
  add_skin(surface, top);
  add_wall(surface, grid->front(), -Vec3::UnitY());
  add_wall(surface, backwards(grid->back()), Vec3::UnitY());
  add_wall(surface, backwards(column(*grid, 0)), -Vec3::UnitX());
  add_wall(surface, column(*grid, grid->front().size() - 1), Vec3::UnitX());
  const Vec2 half = 0.5 * solid.size;
  add_level_cap(surface, {{-half, {half.x(), -half.y()}, half, {-half.x(), half.y()}}}, 0.0, false);
  return surface.mesh();
}

}  // namespace roomgen::shape
