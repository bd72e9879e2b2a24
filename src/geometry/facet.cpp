#include "facet.h"

#include <Eigen/Geometry>
#include <cmath>

namespace roomgen {

namespace {

constexpr double no_volume = 1e-15;  // of direction and edges: they lie in one plane

}  // namespace

Facet facet(const Mesh& mesh, const Triangle& t) {
  return {mesh.positions[t[0]].cast<double>(), mesh.positions[t[1]].cast<double>(),
          mesh.positions[t[2]].cast<double>()};
}

Bounds3 bounds(const Facet& t) {
  return {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)};
}

// Ericson, Real-Time Collision Detection, 5.1.5.
Vec3 closest_point(const Facet& t, const Vec3& p) {
  const Vec3 ab = t.b - t.a, ac = t.c - t.a, ap = p - t.a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return t.a;
  const Vec3 bp = p - t.b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return t.b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return t.a + d1 / (d1 - d3) * ab;
  const Vec3 cp = p - t.c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return t.c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return t.a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6)
    return t.b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t.c - t.b);
  const double sum = va + vb + vc;
  return sum > 0 ? Vec3(t.a + (vb * ab + vc * ac) / sum) : t.a;
}

// Moeller and Trumbore 1997.
std::optional<FacetCrossing> crossing(const Facet& t, const Ray& ray, double slack) {
  const Vec3 u = t.b - t.a, v = t.c - t.a;
  const Vec3 p = ray.direction.cross(v);
  const double determinant = u.dot(p);
  if (std::abs(determinant) < no_volume) return std::nullopt;
  const Vec3 s = ray.origin - t.a;
  const double alpha = s.dot(p) / determinant;
  if (alpha < -slack || alpha > 1 + slack) return std::nullopt;
  const Vec3 q = s.cross(u);
  const double beta = ray.direction.dot(q) / determinant;
  if (beta < -slack || alpha + beta > 1 + slack) return std::nullopt;
  return FacetCrossing{v.dot(q) / determinant, determinant < 0};
}

}  // namespace roomgen
