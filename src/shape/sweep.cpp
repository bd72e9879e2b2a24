#include <Eigen/Geometry>
#include <algorithm>

#include "chain.h"
#include "checks.h"
#include "rounds.h"
#include "skin.h"

namespace roomgen::shape {

namespace {

// The directions of a section's x and y; along = x cross y.
struct Frame {
  Vec3 x, y, along;
};

// Level paths have y up; upright ones have y to the back.
Frame first_frame(const Vec3& along) {
  const Vec3 wanted = std::abs(along.z()) > 0.999 ? Vec3::UnitY() : Vec3::UnitZ();
  const Vec3 y = (wanted - wanted.dot(along) * along).normalized();
  return {y.cross(along), y, along};
}

// The frame after the turn into another direction, without roll: reflected in the plane between
// both pieces and then along the way (the double reflection of Wang et al. 2008, exact for straight
// pieces).
Frame carried(const Frame& frame, const Vec3& along) {
  const Vec3 mirror = (frame.along + along).normalized();
  const auto reflect = [&](const Vec3& v) { return Vec3(v - 2.0 * v.dot(mirror) * mirror); };
  Frame next{reflect(frame.x), Vec3::Zero(), along};
  next.x = (next.x - next.x.dot(along) * along).normalized();
  next.y = along.cross(next.x);
  return next;
}

Frame rolled(const Frame& frame, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * frame.x + s * frame.y, c * frame.y - s * frame.x, frame.along};
}

// The path with its straight pieces' frames.
class Route {
 public:
  explicit Route(const Chain3& path) : path_(path) {
    const std::size_t n = path.pieces();
    lengths_.push_back(0.0);
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 piece = point(i + 1) - point(i);
      directions_.push_back(piece.normalized());
      lengths_.push_back(lengths_.back() + piece.norm());
    }
    frames_.push_back(first_frame(directions_.front()));
    for (std::size_t i = 1; i < n; ++i) frames_.push_back(carried(frames_.back(), directions_[i]));
    if (path.closed) {
      const Frame back = carried(frames_.back(), directions_.front());
      leftover_ = std::atan2(back.x.dot(frames_[0].y), back.x.dot(frames_[0].x));
    }
  }

  std::size_t rows() const { return path_.size(); }
  bool turns_back() const {
    for (std::size_t i = 0; i < rows(); ++i)
      if (before(i).dot(after(i)) < -0.985) return true;
    return false;
  }
  double part(std::size_t row) const { return lengths_[row] / lengths_.back(); }

  // The section's points at a row, on the plane that halves the turn between the pieces.
  std::vector<Vec3> ring(const std::vector<Vec2>& section, std::size_t row, double scale,
                         double twist) const {
    const std::size_t piece = row < frames_.size() ? row : row - 1;
    const Frame frame = rolled(frames_[piece], twist - leftover_ * part(row));
    const Vec3 mitre = (before(row) + after(row)).normalized();
    std::vector<Vec3> result;
    for (const auto& p : section) {
      const Vec3 across = scale * (p.x() * frame.x + p.y() * frame.y);
      result.push_back(point(row) + across -
                       across.dot(mitre) / frame.along.dot(mitre) * frame.along);
    }
    return result;
  }
  const Vec3& direction(std::size_t piece) const { return directions_[piece]; }

 private:
  const Vec3& point(std::size_t i) const { return path_.points[i % path_.size()]; }
  const Vec3& before(std::size_t row) const {
    if (row > 0) return directions_[row - 1];
    return path_.closed ? directions_.back() : directions_.front();
  }
  const Vec3& after(std::size_t row) const {
    return row < directions_.size() ? directions_[row] : directions_.back();
  }

  const Chain3& path_;
  std::vector<double> lengths_;
  std::vector<Vec3> directions_;
  std::vector<Frame> frames_;
  double leftover_ = 0.0;
};

double reach(const Chain2& section) {
  double result = 0.0;
  for (const auto& p : section.points) result = std::max(result, p.norm());
  return result;
}

// A twist needs rows even where the path is straight.
Chain3 divided(const Chain3& path, double twist, double step) {
  double length = 0.0;
  for (std::size_t i = 0; i < path.pieces(); ++i)
    length += (path.points[(i + 1) % path.size()] - path.points[i]).norm();
  Chain3 result;
  result.closed = path.closed;
  for (std::size_t i = 0; i < path.size(); ++i) {
    result.add(path.points[i], path.crease[i]);
    if (i >= path.pieces()) break;
    const Vec3 piece = path.points[(i + 1) % path.size()] - path.points[i];
    const double turn = std::abs(twist) * piece.norm() / length;
    const int parts = std::clamp(static_cast<int>(std::ceil(turn / step)), 1, 512);
    for (int k = 1; k < parts; ++k)
      result.add(path.points[i] + piece * (static_cast<double>(k) / parts), false);
  }
  return result;
}

void add_ends(SurfaceBuilder& surface, const Route& route, const Chain2& section, const Skin& skin) {
  add_cap(surface, {section.points}, skin.rows.back(), route.direction(skin.rows.size() - 2));
  Loop loop = section.points;
  auto points = skin.rows.front();
  std::reverse(loop.begin(), loop.end());
  std::reverse(points.begin(), points.end());
  for (auto& p : loop) p.x() = -p.x();
  add_cap(surface, {loop}, points, -route.direction(0));
}

Status check(const Sweep& solid) {
  if (!(solid.taper >= 0.0 && solid.taper <= 100.0))
    return input_error("sweep: the taper must be between 0 and 100");
  if (!(std::abs(solid.twist) <= 200 * pi))
    return input_error("sweep: the twist must be at most a hundred turns");
  if (!solid.path.closed) return {};
  if (std::abs(solid.taper - 1.0) > 1e-9) return input_error("sweep: a closed path cannot taper");
  if (std::abs(std::remainder(solid.twist, 2 * pi)) > 1e-6)
    return input_error("sweep: a closed path can only be twisted by whole turns");
  return {};
}

}  // namespace

Result<Mesh> mesh(const Sweep& solid, double tolerance) {
  if (auto s = check(solid); !s) return s.error();
  const auto section = sample_outline(solid.section, tolerance, "sweep");
  if (!section) return section.error();
  // The path's chords and the section's distance from it share the tolerance.
  const double outer = reach(*section) * std::max(1.0, solid.taper);
  const double step = arc_step(outer, 0.5 * tolerance);
  auto path = sample(solid.path, 0.5 * tolerance, std::min(step, pi / 6));
  if (!path) return with_context(path.error(), "sweep");
  if (solid.twist != 0.0) *path = divided(*path, solid.twist, step);

  const Route route(*path);
  if (route.turns_back()) return input_error("sweep: the path turns back on itself");
  Skin skin;
  skin.rows_closed = path->closed;
  skin.row_crease = path->crease;
  skin.column_crease = section->crease;
  for (std::size_t row = 0; row < route.rows(); ++row) {
    const double part = route.part(row);
    skin.rows.push_back(
        route.ring(section->points, row, 1.0 + (solid.taper - 1.0) * part, solid.twist * part));
  }
  SurfaceBuilder surface;
  add_skin(surface, skin);
  if (!path->closed) add_ends(surface, route, *section, skin);
  return surface.mesh();
}

}  // namespace roomgen::shape
