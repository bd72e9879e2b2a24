#include <cmath>
#include <polyclipping/clipper.hpp>

#include "triangulate.h"

namespace roomgen {

namespace {

// Clipper counts in whole numbers; up to 1 km it does without its 128-bit arithmetic.
constexpr double units_in_a_metre = 1e6;
constexpr double least_area = 1e-8;  // m2, of slivers that rounding leaves

ClipperLib::Path path_of(const Loop& points) {
  const auto whole = [](double metres) {
    return static_cast<ClipperLib::cInt>(std::llround(metres * units_in_a_metre));
  };
  ClipperLib::Path path;
  for (const auto& point : points) path.emplace_back(whole(point.x()), whole(point.y()));
  return path;
}

Loop loop_of(const ClipperLib::Path& path) {
  Loop loop;
  for (const auto& point : path)
    loop.push_back(Vec2(static_cast<double>(point.X), static_cast<double>(point.Y)) /
                   units_in_a_metre);
  return loop;
}

std::vector<Loop> loops_of(const ClipperLib::Paths& paths) {
  std::vector<Loop> loops;
  for (const auto& path : paths)
    if (Loop loop = loop_of(path); std::abs(signed_area(loop)) > least_area)
      loops.push_back(std::move(loop));
  return loops;
}

}  // namespace

std::vector<Loop> difference(const Polygon& polygon, std::span<const Polygon> others) {
  ClipperLib::Clipper clipper(ClipperLib::ioStrictlySimple);
  bool overlapped = false;
  for (const auto& other : others)
    if (bounds(other).overlaps(bounds(polygon))) {
      clipper.AddPath(path_of(other.points), ClipperLib::ptClip, true);
      overlapped = true;
    }
  if (!overlapped) return {polygon.points};
  clipper.AddPath(path_of(polygon.points), ClipperLib::ptSubject, true);
  ClipperLib::Paths left;
  clipper.Execute(ClipperLib::ctDifference, left, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return loops_of(left);
}

std::vector<Loop> around_lines(std::span<const Loop> lines, double width, double tolerance) {
  ClipperLib::ClipperOffset offset(2.0, tolerance * units_in_a_metre);
  for (const auto& line : lines)
    offset.AddPath(path_of(line), ClipperLib::jtRound, ClipperLib::etOpenRound);
  ClipperLib::Paths around;
  offset.Execute(around, 0.5 * width * units_in_a_metre);
  ClipperLib::SimplifyPolygons(around, ClipperLib::pftNonZero);
  return loops_of(around);
}

}  // namespace roomgen
