#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/random.h"
#include "brief/reply_measure.h"
#include "chat/loose_json.h"
#include "plan/floor_plan.h"
#include "plan/room_openings.h"
#include "plan_answers.h"
#include "roomgen/base/text.h"

namespace roomgen::design {

namespace {

constexpr double least_height = 2.0;
constexpr double greatest_height = 10.0;
constexpr std::size_t max_corners = 64;
constexpr std::size_t max_type = 60;  ///< bytes
constexpr int max_windows = 3;

const std::vector<std::string> room_keys = {"room", "room info", "layout"};
const std::vector<std::string> room_type_keys = {"room type", "type", "name", "kind"};
const std::vector<std::string> room_size_keys = {"size m", "size",      "dimensions", "dimensions m",
                                            "area m", "room size", "size cm"};
const std::vector<std::string> polygon_keys = {"polygon m", "polygon", "vertices",
                                               "corners",   "outline", "floor plan"};
const std::vector<std::string> height_keys = {"height m", "height", "ceiling height",
                                              "wall height"};
const std::vector<std::string> window_keys = {"windows", "window count"};

double side_labelled(const std::vector<brief::Measure>& measures,
                     std::initializer_list<const char*> names) {
  for (const char* name : names)
    for (const auto& measure : measures)
      if (measure.label == name) return measure.value;
  return std::nan("");
}

// Nobody asks for a room of more than 50 m, but models answer in centimetres.
double unit_for(double greatest, bool has_unit) {
  return !has_unit && greatest > greatest_room_side ? brief::centimetre : 1.0;
}

std::optional<Vec2> read_size(const Json& room, std::vector<std::string>& repairs) {
  const Json* given = member(room, room_size_keys);
  const auto measures = brief::measures_in(given ? *given : room);
  if (measures.empty()) return std::nullopt;
  Vec2 size(side_labelled(measures, {"width", "w", "x"}),
            side_labelled(measures, {"depth", "length", "d", "l", "y"}));
  // "4.2 x 3.6 m" has an x as well.
  if (std::isnan(size.sum())) {
    if (!given || measures.size() < 2) return std::nullopt;
    size = {measures[0].value, measures[1].value};
  }
  size *= unit_for(size.maxCoeff(), measures[0].has_unit);
  const Vec2 bounded = size.cwiseMax(least_room_side).cwiseMin(greatest_room_side);
  if (bounded != size) repairs.emplace_back("the size of the room was bounded");
  return bounded;
}

std::vector<Vec2> read_corners(const Json& value) {
  std::vector<Vec2> corners;
  if (!value.is_array() || value.size() > max_corners) return corners;
  for (const auto& corner : value) {
    const auto measures = brief::measures_in(corner);
    if (measures.size() < 2) return {};
    corners.emplace_back(measures[0].value, measures[1].value);
  }
  return corners;
}

Bounds2 box_of(const std::vector<Vec2>& points) {
  Bounds2 box;
  for (const auto& point : points) box.add(point);
  return box;
}

bool has_sound_size(const Vec2& size) {
  return size.minCoeff() >= least_room_side && size.maxCoeff() <= greatest_room_side;
}

/// A floor that is no rectangle, or the size of one.
struct Floor {
  std::optional<Polygon> polygon;
  std::optional<Vec2> size;
};

Floor read_floor(const Json& room, std::vector<std::string>& repairs) {
  const Json* outline = member(room, polygon_keys);
  auto corners = outline ? read_corners(*outline) : std::vector<Vec2>{};
  if (corners.size() < 2) {
    if (outline) repairs.emplace_back("the outline of the room is no list of corners [x, y]");
    return {std::nullopt, read_size(room, repairs)};
  }
  Bounds2 box = box_of(corners);
  const double unit = unit_for(box.size().maxCoeff(), false);
  for (auto& corner : corners) corner = unit * (corner - box.low);
  box = box_of(corners);
  if (auto polygon = make_polygon(corners); polygon && has_sound_size(box.size()))
    return {*std::move(polygon), std::nullopt};
  repairs.emplace_back(
      "the outline of the room is no simple polygon; its bounding rectangle is "
      "taken");
  return {std::nullopt, box.size().cwiseMax(least_room_side).cwiseMin(greatest_room_side)};
}

double read_height(const Json& room, double usual, std::vector<std::string>& repairs) {
  const Json* value = member(room, height_keys);
  const auto given = value ? brief::single_measure(*value) : std::nullopt;
  if (!given) return usual;
  const double height = given->value * unit_for(given->value, given->has_unit);
  const double bounded = std::clamp(height, least_height, greatest_height);
  if (bounded != height) repairs.emplace_back("the height of the room was bounded");
  return bounded;
}

plan::RoomOpenings openings_of(const Json& room, const brief::RoomKind& kind,
                               const brief::Brief& brief, Random random) {
  const int usual = random.integer(kind.windows.low, kind.windows.high);
  const Json* value = member(room, window_keys);
  const auto answered = value && value->is_array() ? std::optional(static_cast<int>(value->size()))
                        : value                    ? brief::count_in(*value)
                                                   : std::nullopt;
  const auto said = brief.windows ? brief.windows : answered;
  const int windows = std::clamp(said.value_or(usual), 0, max_windows);
  return {windows, said.has_value(), brief.wide_windows, brief.openings, brief.told_from_door};
}

Room given_room(const PlanRequest& request, const brief::RoomKind& kind,
                std::vector<std::string>& repairs) {
  Room room = *request.room;
  if (room.type.empty()) room.type = kind.type;
  plan::ensure_door(room, kind, repairs);
  return room;
}

}  // namespace

const Json& room_part(const Json& json) {
  const Json* room = member(json, room_keys);
  return room && room->is_object() ? *room : json;
}

std::string room_type_in(const Json& json) {
  const Json* type = member(room_part(json), room_type_keys);
  if (!type && member(json, room_keys)) type = member(json, room_keys);
  if (!type || !type->is_string()) return "";
  const std::string text = join(words(type->get_ref<const std::string&>()), " ");
  return text.size() <= max_type ? text : "";
}

brief::RoomKind kind_of_room(const std::string& type, const brief::RoomKinds& kinds) {
  brief::RoomKind kind = kinds.get(type);
  if (!kinds.types.count(type))
    for (const auto& [name, known] : kinds.types)
      if (std::find(known.names.begin(), known.names.end(), type) != known.names.end())
        kind = known;
  kind.type = type;
  return kind;
}

Room read_reply_room(const Json& json, const PlanRequest& request, const brief::RoomKind& kind,
                     const brief::Brief& brief, double furniture,
                     std::vector<std::string>& repairs) {
  if (request.room) return given_room(request, kind, repairs);
  const Random random(request.seed);
  const Json& part = room_part(json);
  brief::RoomKind own = kind;
  own.height = read_height(part, kind.height, repairs);
  const plan::RoomOpenings openings = openings_of(part, kind, brief, random.fork("windows"));
  const Floor floor = request.size ? Floor{std::nullopt, request.size} : read_floor(part, repairs);
  if (!floor.polygon && !floor.size)
    repairs.emplace_back("the answer gives no size of the room; one was chosen");
  const Vec2 size = floor.polygon ? Vec2(bounds(*floor.polygon).size())
                    : floor.size
                        ? *floor.size
                        : plan::choose_size(kind, brief, 1.0, furniture, {0, 0}, random.fork("size"));
  const auto make = [&](const brief::Outline& outline) {
    return plan::make_room(own, outline, openings, random.fork("openings"), repairs);
  };
  if (floor.polygon) {
    const Room room = make({*floor.polygon, {}, {}});
    const bool has_entrance = !room.openings.empty() && room.openings.front().is_entrance();
    if (check(room) && has_entrance) return room;
    repairs.emplace_back("the outline of the room takes no door; its bounding rectangle is taken");
    return make(brief::rectangle_of(size));
  }
  // Without an outline of its own, the answer is taken to mean the prompt's.
  const bool is_box = floor.size || brief.size;
  return make(plan::choose_outline(brief, size, is_box, repairs, random.fork("outline")));
}

}  // namespace roomgen::design
