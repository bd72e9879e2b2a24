// The nearest points of two triangles, after PQP (Larsen, Gottschalk, Lin and Manocha 1999).
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>

#include "facet.h"

namespace roomgen {

namespace {

using Corners3 = std::array<Vec3, 3>;

// Of the segments p to p + u and q to q + v; Ericson, Real-Time Collision Detection, 5.1.9.
NearestPoints nearest_of_segments(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v) {
  const Vec3 r = p - q;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), ur = u.dot(r), vr = v.dot(r);
  const double uv = u.dot(v), area = uu * vv - uv * uv;
  double s = area > 0.0 ? std::clamp((uv * vr - ur * vv) / area, 0.0, 1.0) : 0.0;
  double t = vv > 0.0 ? (uv * s + vr) / vv : 0.0;
  if (t < 0.0 || t > 1.0) {
    t = std::clamp(t, 0.0, 1.0);
    s = uu > 0.0 ? std::clamp((uv * t - ur) / uu, 0.0, 1.0) : 0.0;
  } else if (vv <= 0.0) {
    s = uu > 0.0 ? std::clamp(-ur / uu, 0.0, 1.0) : 0.0;
  }
  const Vec3 on_a = p + s * u, on_b = q + t * v;
  return {(on_a - on_b).norm(), on_a, on_b};
}

class FacetPair {
 public:
  FacetPair(const Facet& a, const Facet& b) : facets_{a, b}, corners_{{{a.a, a.b, a.c}, {b.a, b.b, b.c}}} {
    best_.distance = std::numeric_limits<double>::infinity();
  }

  NearestPoints run() {
    if (edges_decide()) return best_;
    for (int side = 0; side < 2; ++side)
      for (const auto& corner : corners_[side]) try_corner(side, corner);
    if (!apart_) find_common_point();
    return best_;
  }

 private:
  // Looks at all pairs of edges. The two nearest points of a pair are those of the facets when the
  // slab between them parts the facets' other corners.
  bool edges_decide() {
    const auto& [s, t] = corners_;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const auto found =
            nearest_of_segments(s[i], s[(i + 1) % 3] - s[i], t[j], t[(j + 1) % 3] - t[j]);
        if (found.distance > best_.distance) continue;
        best_ = found;
        const Vec3 across = found.on_b - found.on_a;
        const double own = (s[(i + 2) % 3] - found.on_a).dot(across);
        const double other = (t[(j + 2) % 3] - found.on_b).dot(across);
        if (own <= 0.0 && other >= 0.0) return true;
        const double gap = across.squaredNorm() - std::max(own, 0.0) + std::min(other, 0.0);
        if (gap > 0.0) apart_ = true;
      }
    return false;
  }

  void try_corner(int side, const Vec3& corner) {
    const Vec3 on_other = closest_point(facets_[1 - side], corner);
    const double distance = (corner - on_other).norm();
    if (distance >= best_.distance) return;
    best_ = side == 0 ? NearestPoints{distance, corner, on_other}
                      : NearestPoints{distance, on_other, corner};
  }

  void find_common_point() {
    for (int side = 0; side < 2; ++side)
      for (int i = 0; i < 3; ++i) {
        const Vec3& from = corners_[side][i];
        const Ray edge{from, corners_[side][(i + 1) % 3] - from};
        const auto met = crossing(facets_[1 - side], edge);
        if (!met || met->at < 0.0 || met->at > 1.0) continue;
        const Vec3 point = edge.origin + met->at * edge.direction;
        best_ = {0.0, point, point};
        return;
      }
  }

  std::array<Facet, 2> facets_;
  std::array<Corners3, 2> corners_;
  NearestPoints best_;
  bool apart_ = false;
};

}  // namespace

NearestPoints nearest_points(const Facet& a, const Facet& b) {
  return FacetPair(a, b).run();
}

}  // namespace roomgen
