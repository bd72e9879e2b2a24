#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "chain.h"
#include "checks.h"
#include "roomgen/geometry/polygon.h"
#include "skin.h"

namespace roomgen::shape {

namespace {

// An outline by the part of the way around it, 0 to 1, from its start. The way runs evenly between
// anchors: creases when all levels have as many of them, so that edges lead to edges.
class Ring {
 public:
  Ring(const Chain2& chain, bool by_creases) : points_(chain.points), crease_(chain.crease) {
    if (by_creases)
      start_at(first_crease());
    else
      start_at_front();
    measure(by_creases);
  }

  std::vector<double> parts(bool creases) const {
    std::vector<double> result;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (crease_[i] == creases) result.push_back(part_[i]);
    return result;
  }

  Vec2 at(double part) const {
    const auto above = std::upper_bound(part_.begin(), part_.end(), part + 1e-12);
    const auto i = static_cast<std::size_t>(above - part_.begin()) - 1;
    const double next = i + 1 < part_.size() ? part_[i + 1] : 1.0;
    const double t = (part - part_[i]) / (next - part_[i]);
    if (t < 1e-9) return points_[i];
    return points_[i] + t * (points_[(i + 1) % points_.size()] - points_[i]);
  }

 private:
  Vec2 middle() const {
    Vec2 low = points_.front(), high = low;
    for (const auto& p : points_) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    return 0.5 * (low + high);
  }

  // Counter-clockwise from the front, 0 to a full turn.
  double angle(const Vec2& p) const {
    const Vec2 v = p - middle();
    const double a = std::atan2(v.x(), -v.y());
    return a < -1e-9 ? a + 2 * pi : a;
  }

  std::size_t first_crease() const {
    std::size_t best = points_.size();
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (crease_[i] && (best == points_.size() || angle(points_[i]) < angle(points_[best])))
        best = i;
    return best;
  }

  void start_at(std::size_t i) {
    const auto by = static_cast<std::ptrdiff_t>(i);
    std::rotate(points_.begin(), points_.begin() + by, points_.end());
    std::rotate(crease_.begin(), crease_.begin() + by, crease_.end());
  }

  // Where the outline crosses straight before its middle, the foremost crossing; a point is added
  // there.
  void start_at_front() {
    const Vec2 center = middle();
    std::size_t best = points_.size();
    double lowest = center.y();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vec2 &a = points_[i], &b = points_[(i + 1) % points_.size()];
      if (!(a.x() <= center.x() && b.x() > center.x())) continue;
      const double y = crossing(a, b, center.x());
      if (best == points_.size() || y < lowest) {
        best = i;
        lowest = y;
      }
    }
    if (best == points_.size()) return;
    const Vec2 front(center.x(), lowest);
    if ((front - points_[best]).norm() < 1e-6) return start_at(best);
    const std::size_t next = (best + 1) % points_.size();
    if ((front - points_[next]).norm() < 1e-6) return start_at(next);
    start_at(next);
    points_.insert(points_.begin(), front);
    crease_.insert(crease_.begin(), false);
  }

  static double crossing(const Vec2& a, const Vec2& b, double x) {
    return a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
  }

  void measure(bool by_creases) {
    const std::size_t n = points_.size();
    std::vector<std::size_t> anchors{0};
    if (by_creases)
      for (std::size_t i = 1; i < n; ++i)
        if (crease_[i]) anchors.push_back(i);
    anchors.push_back(n);
    const auto spans = static_cast<double>(anchors.size() - 1);
    for (std::size_t span = 0; span + 1 < anchors.size(); ++span) {
      std::vector<double> way{0.0};
      for (std::size_t i = anchors[span]; i < anchors[span + 1]; ++i)
        way.push_back(way.back() + (points_[(i + 1) % n] - points_[i]).norm());
      for (std::size_t k = 0; k + 1 < way.size(); ++k)
        part_.push_back((static_cast<double>(span) + way[k] / way.back()) / spans);
    }
  }

  std::vector<Vec2> points_;
  std::vector<bool> crease_;
  std::vector<double> part_;
};

// The places around that all levels are sampled at: every crease, and other points unless they come
// close to one that is there already.
struct Places {
  std::vector<double> parts;
  std::vector<bool> crease;
};

Places common_places(const std::vector<Ring>& rings) {
  std::vector<std::pair<double, bool>> places;
  std::size_t most = 0;
  const auto near = [&](double part, double distance) {
    return std::any_of(places.begin(), places.end(), [&](const auto& place) {
      return std::abs(std::remainder(place.first - part, 1.0)) < distance;
    });
  };
  for (const auto& ring : rings) {
    for (double part : ring.parts(true))
      if (!near(part, 1e-6)) places.push_back({part, true});
    most = std::max(most, ring.parts(true).size() + ring.parts(false).size());
  }
  if (!near(0.0, 1e-6)) places.push_back({0.0, false});
  for (const auto& ring : rings)
    for (double part : ring.parts(false))
      if (!near(part, 0.45 / static_cast<double>(most))) places.push_back({part, false});
  std::sort(places.begin(), places.end());
  Places result;
  for (const auto& [part, crease] : places) {
    result.parts.push_back(part);
    result.crease.push_back(crease);
  }
  return result;
}

bool is_crease(const std::vector<Vec3>& below, const std::vector<Vec3>& here,
               const std::vector<Vec3>& above) {
  for (std::size_t j = 0; j < here.size(); ++j) {
    const Vec3 in = here[j] - below[j], out = above[j] - here[j];
    if (std::atan2(in.cross(out).norm(), in.dot(out)) > crease_angle) return true;
  }
  return false;
}

// Smooth columns through the levels' points; all have the rows that the most bent one needs.
std::vector<std::vector<Vec3>> smoothed(const std::vector<std::vector<Vec3>>& rows,
                                        double tolerance) {
  const std::size_t columns = rows.front().size(), spans = rows.size() - 1;
  std::vector<std::size_t> steps(spans, 1);
  const auto piece = [&](std::size_t column, std::size_t span, double t) -> Vec3 {
    const auto tangent = [&](std::size_t i) -> Vec3 {
      const Vec3& p = rows[i][column];
      if (i == 0) return (rows[1][column] - p).normalized();
      if (i == spans) return (p - rows[i - 1][column]).normalized();
      return ((p - rows[i - 1][column]).normalized() + (rows[i + 1][column] - p).normalized())
          .normalized();
    };
    const Vec3 &a = rows[span][column], &d = rows[span + 1][column];
    const double handle = (d - a).norm() / 2.5614, s = 1.0 - t;
    return s * s * s * a + 3 * s * s * t * (a + handle * tangent(span)) +
           3 * s * t * t * (d - handle * tangent(span + 1)) + t * t * t * d;
  };
  for (std::size_t span = 0; span < spans; ++span)
    for (std::size_t j = 0; j < columns; ++j) {
      // The distance of a quarter of the piece from its chord falls with the square of the steps.
      double sag = 0.0;
      for (double t : {0.25, 0.5, 0.75})
        sag = std::max(
            sag, (piece(j, span, t) - ((1 - t) * rows[span][j] + t * rows[span + 1][j])).norm());
      const auto needed = static_cast<std::size_t>(std::ceil(std::sqrt(sag / tolerance)));
      steps[span] = std::clamp<std::size_t>(needed, steps[span], 48);
    }
  std::vector<std::vector<Vec3>> result;
  for (std::size_t span = 0; span < spans; ++span)
    for (std::size_t k = 0; k < steps[span]; ++k) {
      auto& row = result.emplace_back();
      for (std::size_t j = 0; j < columns; ++j)
        row.push_back(
            k == 0 ? rows[span][j]
                   : piece(j, span, static_cast<double>(k) / static_cast<double>(steps[span])));
    }
  result.push_back(rows.back());
  return result;
}

Result<std::vector<Ring>> rings_of(const Loft& solid, double tolerance) {
  std::vector<Chain2> chains;
  for (const auto& level : solid.levels) {
    auto chain =
        sample_outline(level.outline, tolerance, "loft, level " + std::to_string(chains.size()));
    if (!chain) return chain.error();
    chains.push_back(std::move(*chain));
  }
  const auto creases = [](const Chain2& chain) {
    return std::count(chain.crease.begin(), chain.crease.end(), true);
  };
  const bool by_creases =
      creases(chains.front()) > 0 && std::all_of(chains.begin(), chains.end(), [&](const auto& c) {
        return creases(c) == creases(chains.front());
      });
  std::vector<Ring> rings;
  for (const auto& chain : chains) rings.emplace_back(chain, by_creases);
  return rings;
}

Status check(const Loft& solid) {
  if (solid.levels.size() < 2 || solid.levels.size() > 256)
    return input_error("loft: needs 2 to 256 levels");
  for (std::size_t i = 0; i < solid.levels.size(); ++i) {
    const double z = solid.levels[i].z;
    if (!(std::abs(z) <= greatest_size)) return input_error("loft: a height is not a number");
    if (i > 0 && z - solid.levels[i - 1].z < smallest_size)
      return input_error("loft: the heights of the levels must grow");
  }
  return {};
}

}  // namespace

Result<Mesh> mesh(const Loft& solid, double tolerance) {
  if (auto s = check(solid); !s) return s.error();
  const auto rings = rings_of(solid, tolerance);
  if (!rings) return rings.error();
  const Places places = common_places(*rings);
  Skin skin;
  skin.column_crease = places.crease;
  std::vector<Loop> ends;
  for (std::size_t i = 0; i < rings->size(); ++i) {
    Loop loop;
    for (double part : places.parts) loop.push_back((*rings)[i].at(part));
    if (!is_simple(loop)) return input_error("loft: an outline is too narrow to be resampled");
    skin.rows.push_back(raised(loop, solid.levels[i].z));
    if (i == 0 || i + 1 == rings->size()) ends.push_back(loop);
  }
  if (solid.straight) {
    skin.row_crease.assign(skin.rows.size(), false);
    for (std::size_t i = 1; i + 1 < skin.rows.size(); ++i)
      skin.row_crease[i] = is_crease(skin.rows[i - 1], skin.rows[i], skin.rows[i + 1]);
  } else {
    skin.rows = smoothed(skin.rows, tolerance);
  }
  SurfaceBuilder surface;
  add_skin(surface, skin);
  add_level_cap(surface, {ends.front()}, solid.levels.front().z, false);
  add_level_cap(surface, {ends.back()}, solid.levels.back().z, true);
  return surface.mesh();
}

}  // namespace roomgen::shape
