#include <limits>
#include <nlohmann/json.hpp>

#include "brief/reply_measure.h"
#include "chat/loose_json.h"
#include "place_answers.h"
#include "plan_answers.h"
#include "roomgen/base/text.h"

namespace roomgen::design {

namespace {

constexpr double farthest_outside = 1.0;
constexpr double off_the_wall = 1e-3;  ///< of what is moved into the room

/// Two coordinates as they are written.
struct Given {
  Vec2 point;
  bool units = false;   ///< with a unit, so metres for sure
  bool labels = false;  ///< as x and y, so in order for sure
};

std::optional<Given> in_order(const std::vector<brief::Measure>& measures) {
  const brief::Measure* x = nullptr;
  const brief::Measure* y = nullptr;
  for (const auto& measure : measures) {
    if (measure.label == "x" && !x) x = &measure;
    if (measure.label == "y" && !y) y = &measure;
  }
  const bool labels = x && y;
  if (!labels) {
    if (measures.size() < 2 || x || y) return std::nullopt;
    x = &measures[0];
    y = &measures[1];
  }
  return Given{{x->value, y->value}, x->has_unit || y->has_unit, labels};
}

std::optional<Given> read_given(const Json& value) {
  // [[1.2, 3.0]]
  if (value.is_array() && value.size() == 1) return read_given(value[0]);
  // A coordinate that is no number must not let the third one take its place.
  if (value.is_array())
    for (std::size_t i = 0; i < 2 && i < value.size(); ++i)
      if (!brief::single_measure(value[i])) return std::nullopt;
  return in_order(brief::measures_in(value));
}

Vec2 to_scene(const Vec2& given, const Polygon& room, MarksFrame frame) {
  if (frame == MarksFrame::plan) return given;
  const Bounds2 box = bounds(room);
  return {box.high.x() - given.y(), box.high.y() - given.x()};
}

Vec2 nearest_inside(const Polygon& room, const Vec2& point) {
  Vec2 best = point;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < room.size(); ++k) {
    const Vec2 on_wall = closest_point(room.edge(k), point);
    if ((on_wall - point).norm() >= least) continue;
    least = (on_wall - point).norm();
    best = on_wall;
  }
  for (std::size_t k = 0; k < room.size(); ++k)
    if (distance(room.edge(k), best) < off_the_wall) best += off_the_wall * room.inward(k);
  return best;
}

/// A way to understand coordinates.
struct Reading {
  double scale;
  bool swap;
  double least;        ///< the larger coordinate must be at least so large
  const char* repair;  ///< empty: as it is given
};
constexpr Reading as_given = {1.0, false, 0.0, ""};
constexpr Reading swapped = {1.0, true, 0.0, "the coordinates of the location were swapped"};
constexpr Reading centimetres = {0.01, false, 20.0, "the location was read as centimetres"};
constexpr Reading millimetres = {0.001, false, 200.0, "the location was read as millimetres"};

Vec2 under(const Reading& reading, const Given& given, const Polygon& room, MarksFrame frame) {
  const Vec2 point = reading.swap ? Vec2(given.point.y(), given.point.x()) : given.point;
  return to_scene(reading.scale * point, room, frame);
}

std::vector<Reading> readings(const Given& given) {
  std::vector<Reading> all = {as_given};
  if (!given.labels) all.push_back(swapped);
  if (!given.units) all.insert(all.end(), {centimetres, millimetres});
  return all;
}

std::string as_text(const Vec2& point) {
  return "[" + format_number(point.x()) + ", " + format_number(point.y()) + "]";
}

}  // namespace

std::optional<Vec2> read_reply_location(const Json& value, const Polygon& room, MarksFrame frame,
                                        ReplyNotes& notes) {
  const auto given = read_given(value);
  if (!given) {
    notes.lose("the location is not two numbers [x, y] in metres");
    return std::nullopt;
  }
  for (const auto& reading : readings(*given)) {
    const Vec2 point = under(reading, *given, room, frame);
    if (given->point.cwiseAbs().maxCoeff() < reading.least || !contains(room, point)) continue;
    if (*reading.repair) notes.repair(reading.repair);
    return point;
  }
  const Vec2 point = under(as_given, *given, room, frame);
  const Vec2 inside = nearest_inside(room, point);
  if ((inside - point).norm() <= farthest_outside && contains(room, inside)) {
    notes.lose("the location " + as_text(given->point) +
                      " lies outside the room; it was moved to the wall");
    return inside;
  }
  notes.lose("the location " + as_text(given->point) + " lies outside the room");
  return std::nullopt;
}

ReplyStands read_reply_stands(const Json& value) {
  ReplyStands stands;
  const Json* said = value.is_object() ? member(value, {"stands"}) : nullptr;
  if (!said || !said->is_object()) return stands;
  if (const Json* at = member(*said, {"location"}))
    if (const auto given = read_given(*at)) stands.location = given->point;
  if (const Json* yaw = member(*said, {"yaw deg"}); yaw && yaw->is_number())
    stands.facing = wrap_angle(radians(yaw->get<double>()));
  stands.at_wall = said->value("wall", false);
  return stands;
}

}  // namespace roomgen::design
