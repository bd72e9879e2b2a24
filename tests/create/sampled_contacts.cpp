#include "sampled_contacts.h"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

using namespace roomgen;

namespace {

constexpr double pitch = 0.003, near = 0.005;
using Cell = std::tuple<long, long, long>;

struct Region {
  Vec3 low, high;
  bool meets(const Vec3& a, const Vec3& b, const Vec3& c) const {
    return (a.cwiseMin(b).cwiseMin(c).array() <= high.array()).all() &&
           (a.cwiseMax(b).cwiseMax(c).array() >= low.array()).all();
  }
};

void scatter(const Vec3& a, const Vec3& b, const Vec3& c, const Region& region,
             std::vector<Vec3>& points) {
  if (!region.meets(a, b, c)) return;
  const double ab = (a - b).norm(), bc = (b - c).norm(), ca = (c - a).norm();
  if (std::max({ab, bc, ca}) < pitch) {
    points.push_back((a + b + c) / 3);
  } else if (ab >= bc && ab >= ca) {
    scatter(a, (a + b) / 2, c, region, points), scatter((a + b) / 2, b, c, region, points);
  } else if (bc >= ca) {
    scatter(a, b, (b + c) / 2, region, points), scatter(a, (b + c) / 2, c, region, points);
  } else {
    scatter(a, b, (c + a) / 2, region, points), scatter(b, c, (c + a) / 2, region, points);
  }
}

std::vector<Vec3> scattered(const Mesh& mesh, const Region& region) {
  std::vector<Vec3> points;
  for (const auto& t : mesh.triangles)
    scatter(mesh.positions[t[0]].cast<double>(), mesh.positions[t[1]].cast<double>(),
            mesh.positions[t[2]].cast<double>(), region, points);
  return points;
}

Cell cell_of(const Vec3& p) {
  return {std::lround(p.x() / near), std::lround(p.y() / near), std::lround(p.z() / near)};
}

bool surfaces_meet(const Mesh& a, const Mesh& b, const Region& region) {
  std::map<Cell, std::vector<Vec3>> grid;
  for (const auto& p : scattered(a, region)) grid[cell_of(p)].push_back(p);
  for (const auto& p : scattered(b, region)) {
    const auto [x, y, z] = cell_of(p);
    for (long dx = -1; dx <= 1; ++dx)
      for (long dy = -1; dy <= 1; ++dy)
        for (long dz = -1; dz <= 1; ++dz)
          if (const auto found = grid.find({x + dx, y + dy, z + dz}); found != grid.end())
            for (const auto& q : found->second)
              if ((p - q).norm() <= near) return true;
  }
  return false;
}

// Gauss's solid angles (van Oosterom and Strackee 1983).
bool inside(const Vec3& p, const Mesh& mesh) {
  double angle = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]].cast<double>() - p;
    const Vec3 b = mesh.positions[t[1]].cast<double>() - p;
    const Vec3 c = mesh.positions[t[2]].cast<double>() - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2 * std::atan2(a.dot(b.cross(c)),
                            la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle > 2 * pi;
}

bool meet(const Mesh& a, const Mesh& b) {
  const Bounds3 of_a = bounds(a), of_b = bounds(b);
  const Region region = {of_a.low.cwiseMax(of_b.low) - Vec3::Constant(near),
                         of_a.high.cwiseMin(of_b.high) + Vec3::Constant(near)};
  if ((region.low.array() > region.high.array()).any()) return false;
  return surfaces_meet(a, b, region) || inside(a.positions.front().cast<double>(), b) ||
         inside(b.positions.front().cast<double>(), a);
}

}  // namespace

int pieces_by_sampling(const shape::Shape& shape) {
  std::vector<std::size_t> parent(shape.bodies.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t k) {
    while (parent[k] != k) k = parent[k];
    return k;
  };
  for (std::size_t a = 0; a < parent.size(); ++a)
    for (std::size_t b = a + 1; b < parent.size(); ++b)
      if (root(a) != root(b) && meet(shape.bodies[a].mesh, shape.bodies[b].mesh))
        parent[root(a)] = root(b);
  int pieces = 0;
  for (std::size_t k = 0; k < parent.size(); ++k) pieces += parent[k] == k;
  return pieces;
}
