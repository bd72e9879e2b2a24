#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "clauses.h"
#include "roomgen/base/text.h"
#include "roomgen/geometry/polygon.h"

namespace roomgen {

namespace {

constexpr double side_tolerance = 0.05;   // metres
constexpr double area_tolerance = 0.05;   // share
constexpr double ratio_tolerance = 0.1;
constexpr double turn_tolerance = 1e-6;   // sine

struct Turns {
  int corners = 0, inward = 0;
};

// Corners of a polygon that is kept counter-clockwise, without those on a straight line.
Turns turns_of(const Polygon& polygon) {
  Turns turns;
  const auto& points = polygon.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 in = (points[i] - points[(i + points.size() - 1) % points.size()]).normalized();
    const Vec2 out = (points[(i + 1) % points.size()] - points[i]).normalized();
    const double sine = in.x() * out.y() - in.y() * out.x();
    turns.corners += std::abs(sine) > turn_tolerance;
    turns.inward += sine < -turn_tolerance;
  }
  return turns;
}

// What the outlines of data/floor-shapes.json have in common whatever their proportions.
bool has_shape(std::string_view shape, const Turns& turns) {
  static const std::map<std::string, Turns, std::less<>> shapes = {
      {"rectangle", {4, 0}}, {"trapezoid", {4, 0}}, {"triangle", {3, 0}}, {"pentagon", {5, 0}},
      {"hexagon", {6, 0}},   {"octagon", {8, 0}},   {"L", {6, 1}},        {"T", {8, 2}},
      {"U", {8, 2}},         {"Z", {8, 2}},         {"plus", {12, 4}}};
  if (shape == "circle") return turns.corners >= 12 && turns.inward == 0;
  const auto found = shapes.find(shape);
  return found != shapes.end() && found->second.corners == turns.corners &&
         found->second.inward == turns.inward;
}

std::string metres(double value) {
  return format_number(value, 2) + " m";
}

Finding near(double found, double asked, double tolerance, const std::string& unit) {
  if (std::abs(found - asked) <= tolerance) return {};
  return by_fault("it is " + format_number(found, 2) + " " + unit);
}

int number_of(const Room& room, const std::string& kind) {
  return static_cast<int>(
      std::count_if(room.openings.begin(), room.openings.end(), [&](const Opening& opening) {
        return opening.kind == kind || name(opening.type) == kind;
      }));
}

Finding count_openings(const Requirement& requirement, const Room& room) {
  const int there = number_of(room, requirement.category);
  const int asked = static_cast<int>(requirement.amount);
  if (there == asked || (requirement.at_least && there > asked)) return {};
  return by_fault("there are " + std::to_string(there));
}

Finding judge_shape(const Requirement& requirement, const Room& room) {
  return by_fault(has_shape(requirement.category, turns_of(room.polygon))
                      ? ""
                      : "the floor has another shape");
}

}  // namespace

Finding judge_room(const Requirement& requirement, const Room& room) {
  const Vec2 box = bounds(room.polygon).size();
  const std::string& what = requirement.attribute;
  const double asked = requirement.amount;
  if (what == "kind")
    return by_fault(room.type == requirement.category ? "" : "it is a " + room.type);
  if (what == "longer side") return near(box.maxCoeff(), asked, side_tolerance, "m");
  if (what == "shorter side") return near(box.minCoeff(), asked, side_tolerance, "m");
  if (what == "height") return near(room.height, asked, side_tolerance, "m");
  if (what == "area") return near(area(room.polygon), asked, area_tolerance * asked, "m2");
  if (what == "openings") return count_openings(requirement, room);
  if (what == "shape") return judge_shape(requirement, room);
  if (what == "proportion") {
    const double ratio = box.maxCoeff() / box.minCoeff();
    return by_fault(ratio >= asked - ratio_tolerance
                        ? ""
                        : metres(box.maxCoeff()) + " by " + metres(box.minCoeff()));
  }
  if (what == "character") return judge_light(requirement.category, room.light);
  return {Compliance::not_judged, "nothing measures it"};
}

}  // namespace roomgen
