#include "attachment.h"

#include <algorithm>
#include <cmath>

namespace roomgen::lab::annealing {

namespace {

// A thing may be this much longer than the side that it stands against (Infinigen buffers the parent's face
// by as much).
constexpr double overhang = 0.01;

// The outward normal of a side in the thing's own frame.
Vec2 own_normal(Face side) {
  switch (side) {
    case Face::back: return {0, 1};
    case Face::left: return {1, 0};
    case Face::right: return {-1, 0};
    default: return {0, -1};
  }
}

double half_across(Face side, const Vec2& half) {
  return side == Face::left || side == Face::right ? half.x() : half.y();
}

double half_along(Face side, const Vec2& half) {
  return side == Face::left || side == Face::right ? half.y() : half.x();
}

double yaw_with(Face side, const Vec2& looking) {
  const Vec2 own = own_normal(side);
  return wrap_angle(std::atan2(looking.y(), looking.x()) - std::atan2(own.y(), own.x()));
}

// A line of centres beside a plane whose outward normal is given, with its stretch of `from` to `to`.
std::optional<Track> beside(const PutUp& how, Face child, const Vec2& half, const Vec2& normal,
                            double plane, double from, double to) {
  Track track;
  track.normal = normal;
  const bool against = how.type == PutUp::Type::stable_against;
  const double across = half_across(child, half);
  track.offset = against ? plane + how.margin + across : plane - how.margin - across;
  track.yaw = yaw_with(child, against ? Vec2(-normal) : normal);
  const double along = half_along(child, half);
  if (!against) return track.low = from - 10.0, track.high = to + 10.0, track;
  track.low = from + along, track.high = to - along;
  if (track.low > track.high + overhang) return std::nullopt;
  if (track.low > track.high) track.low = track.high = 0.5 * (track.low + track.high);
  return track;
}

}  // namespace

bool is_level(Face face) {
  return face == Face::floor || face == Face::ceiling || face == Face::top || face == Face::bottom ||
         face == Face::support;
}

bool is_upright(Face face) { return !is_level(face); }

bool Track::holds(const Vec2& point, double its_yaw, double tolerance) const {
  const double position = along(point);
  return std::abs(normal.dot(point) - offset) <= tolerance && position >= low - tolerance &&
         position <= high + tolerance && std::abs(wrap_angle(its_yaw - yaw)) <= tolerance;
}

std::optional<Track> track_along_wall(const PutUp& how, const Attachment& attachment, const Vec2& half,
                                      const Polygon& room) {
  const auto k = static_cast<std::size_t>(attachment.wall);
  const Segment wall = room.edge(k);
  const Vec2 normal = room.inward(k), along = left_of(normal);
  const double a = along.dot(wall.a), b = along.dot(wall.b);
  return beside(how, attachment.child, half, normal, normal.dot(wall.a), std::min(a, b), std::max(a, b));
}

std::optional<Track> track_along_side(const PutUp& how, const Attachment& attachment, const Vec2& half,
                                      const Footprint& target) {
  if (target.round()) {
    const Vec2 normal = rotated(target.x_axis(), attachment.direction);
    const double middle = left_of(normal).dot(target.center());
    auto track = beside(how, attachment.child, half, normal,
                        normal.dot(target.center()) + reach_along(target, normal), middle - 10.0, middle + 10.0);
    track->low = track->high = middle;
    return track;
  }
  const Vec2 own = own_normal(attachment.parent);
  const Vec2 normal = own.x() * target.x_axis() + own.y() * target.y_axis();
  const double middle = left_of(normal).dot(target.center());
  const double reach = half_along(attachment.parent, target.half());
  return beside(how, attachment.child, half, normal,
                normal.dot(target.center()) + half_across(attachment.parent, target.half()), middle - reach,
                middle + reach);
}

std::optional<Track> common_track(std::span<const Track> tracks) {
  constexpr double same_line = 0.01;  // metres and radians by which two relations may disagree
  Track common = tracks.front();
  for (const Track& other : tracks.subspan(1)) {
    if (std::abs(wrap_angle(other.yaw - common.yaw)) > same_line) return std::nullopt;
    const double turn = cross(common.normal, other.normal);
    if (std::abs(turn) < 1e-9) {
      const double sign = common.normal.dot(other.normal) > 0 ? 1.0 : -1.0;
      if (std::abs(sign * other.offset - common.offset) > same_line) return std::nullopt;
      const double a = sign * other.low, b = sign * other.high;
      common.low = std::max(common.low, std::min(a, b)), common.high = std::min(common.high, std::max(a, b));
    } else {
      // Where the lines cross: (offset n + s t).m = other.offset.
      const double along =
          (other.offset - common.offset * common.normal.dot(other.normal)) / left_of(common.normal).dot(other.normal);
      const double there = other.along(common.at(along));
      if (there < other.low - same_line || there > other.high + same_line) return std::nullopt;
      if (along < common.low - same_line || along > common.high + same_line) return std::nullopt;
      common.low = common.high = along;
    }
    if (common.low > common.high + same_line) return std::nullopt;
    if (common.low > common.high) common.low = common.high = 0.5 * (common.low + common.high);
  }
  return common;
}

}  // namespace roomgen::lab::annealing
