#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "document_parts.h"
#include "file_limits.h"
#include "file_walls.h"
#include "geometry/outline.h"
#include "room_look_json.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

namespace {

constexpr std::size_t max_corners = 500;
constexpr std::size_t max_openings = 200;
constexpr int max_leaves = 2;
constexpr int max_side_by_side = 20;
constexpr double least_in_wall = 0.001;  // metres: a thinner mesh cannot be fitted to a wall

template <typename Enum, std::size_t count>
Enum read_name(const JsonReader& json, Enum fallback, const std::array<Enum, count>& values) {
  const std::string text = json.text_or(std::string(name(fallback)));
  std::string known;
  for (Enum value : values) {
    if (name(value) == text) return value;
    known += (known.empty() ? "" : ", ") + std::string(name(value));
  }
  json.report("\"" + text + "\" is none of " + known);
  return fallback;
}

std::vector<Vec2> read_outline(const JsonReader& json) {
  std::vector<Vec2> points;
  for (const auto& element : json.elements_or_none(max_outline_points)) {
    const auto p = element.numbers(2, 0.0, 1.0);
    points.emplace_back(p[0], p[1]);
  }
  if (signed_area(points) < 0) std::reverse(points.begin(), points.end());
  return points;
}

Joinery read_joinery(const JsonReader& json) {
  Joinery joinery;
  joinery.asset = read_asset(json["asset"]);
  if (const auto in_wall = json["in_wall"]; in_wall.exists()) {
    const auto depths = in_wall.numbers(2, 0.0, 5.0);
    joinery.wall_front = depths[0];
    joinery.wall_back = depths[1];
    if (depths[1] < depths[0] + least_in_wall)
      in_wall.report("must rise by at least " + format_number(least_in_wall) + " m");
  }
  joinery.mirrored = json["mirrored"].boolean_or(false);
  joinery.side_by_side = static_cast<int>(json["side_by_side"].integer_or(1, 1, max_side_by_side));
  return joinery;
}

Opening read_opening(const JsonReader& json) {
  json.allow_only({"id", "type", "wall", "from", "to", "sill", "head", "hinge", "swing", "kind",
                   "leaves", "glazed", "outline", "asset", "in_wall", "mirrored", "side_by_side",
                   "leads_to", "for"});
  Opening opening;
  opening.type = read_name(json["type"], OpeningType::door,
                           std::array{OpeningType::door, OpeningType::window, OpeningType::passage});
  const bool window = opening.type == OpeningType::window;
  opening.id = json["id"].text(200);
  opening.wall = static_cast<std::size_t>(json["wall"].integer_or(0, 0, max_corners));
  opening.from = json["from"].number(0, max_coordinate);
  opening.to = json["to"].number(0, max_coordinate);
  opening.sill = json["sill"].number_or(window ? default_sill : 0.0, 0, 20);
  opening.head = json["head"].number_or(window ? default_window_head : default_door_head, 0, 20);
  const std::string hinge = json["hinge"].text_or("from");
  if (hinge != "from" && hinge != "to") json["hinge"].report("must be \"from\" or \"to\"");
  opening.hinge_at_from = hinge != "to";
  opening.swing = read_name(json["swing"], DoorSwing::in,
                            std::array{DoorSwing::in, DoorSwing::out, DoorSwing::sliding});
  opening.kind = json["kind"].text_or("", 200);
  opening.leaves = static_cast<int>(json["leaves"].integer_or(1, 1, max_leaves));
  opening.glazed = json["glazed"].boolean_or(false);
  opening.outline = read_outline(json["outline"]);
  opening.joinery = read_joinery(json);
  opening.leads_to = json["leads_to"].text_or("", 200);
  opening.purpose = json["for"].text_or("", 1000);
  return opening;
}

void add_joinery(Json& json, const Joinery& joinery) {
  if (joinery.asset.is_box()) return;
  json["asset"] = to_json(joinery.asset);
  json["in_wall"] = {rounded(joinery.wall_front), rounded(joinery.wall_back)};
  if (joinery.mirrored) json["mirrored"] = true;
  if (joinery.side_by_side > 1) json["side_by_side"] = joinery.side_by_side;
}

Json opening_json(const Opening& opening) {
  Json json;
  json["id"] = opening.id;
  json["type"] = name(opening.type);
  json["wall"] = opening.wall;
  json["from"] = rounded(opening.from);
  json["to"] = rounded(opening.to);
  json["sill"] = rounded(opening.sill);
  json["head"] = rounded(opening.head);
  if (opening.type == OpeningType::door) {
    json["hinge"] = opening.hinge_at_from ? "from" : "to";
    json["swing"] = name(opening.swing);
  }
  if (!opening.kind.empty()) json["kind"] = opening.kind;
  if (opening.leaves != 1) json["leaves"] = opening.leaves;
  if (opening.glazed) json["glazed"] = true;
  for (const auto& p : opening.outline) json["outline"].push_back({rounded(p.x()), rounded(p.y())});
  add_joinery(json, opening.joinery);
  if (!opening.leads_to.empty()) json["leads_to"] = opening.leads_to;
  if (!opening.purpose.empty()) json["for"] = opening.purpose;
  return json;
}

// The same opening in a wall that runs the other way.
void turn_round(Opening& opening) {
  opening.hinge_at_from = !opening.hinge_at_from;
  for (auto& p : opening.outline) p.x() = 1.0 - p.x();
  std::reverse(opening.outline.begin(), opening.outline.end());
}

// A polygon given clockwise is turned round, and needless corners are dropped; openings that count
// walls in the file's order are then moved to the wall they lie on.
void move_openings(Room& room, const std::vector<Vec2>& given, const JsonReader& json) {
  for (auto& opening : room.openings) {
    if (opening.wall >= given.size()) {
      json.report("opening \"" + opening.id + "\" names wall " + std::to_string(opening.wall) +
                  " of " + std::to_string(given.size()));
      return;
    }
    const Vec2 start = given[opening.wall];
    const Vec2 along = given[(opening.wall + 1) % given.size()] - start;
    if (along.norm() < 1e-6) {
      json.report("opening \"" + opening.id + "\" lies on a wall without length");
      return;
    }
    const Vec2 from = start + opening.from * along.normalized();
    const Vec2 to = start + opening.to * along.normalized();
    bool found = false;
    for (std::size_t k = 0; k < room.polygon.size() && !found; ++k) {
      const Segment wall = room.polygon.edge(k);
      if (distance(wall, from) > 1e-3 || distance(wall, to) > 1e-3) continue;
      const double a = (from - wall.a).dot(wall.direction());
      const double b = (to - wall.a).dot(wall.direction());
      opening.wall = k;
      opening.from = std::min(a, b);
      opening.to = std::max(a, b);
      if (b < a) turn_round(opening);
      found = true;
    }
    if (!found)
      return json.report("opening \"" + opening.id + "\" reaches from " +
                         format_number(opening.from) + " to " + format_number(opening.to) +
                         " on a wall of " + format_number(along.norm()) + " m");
  }
}

}  // namespace

Json to_json(const Room& room) {
  Json json;
  if (!room.id.empty()) json["id"] = room.id;
  json["type"] = room.type;
  json["polygon"] = Json::array();
  for (const auto& point : room.polygon.points)
    json["polygon"].push_back({rounded(point.x()), rounded(point.y())});
  json["height"] = rounded(room.height);
  json["openings"] = Json::array();
  for (const auto& opening : room.openings) json["openings"].push_back(opening_json(opening));
  add_look(json, room);
  return json;
}

Room read_room(const JsonReader& json) {
  json.allow_only({"format", "version", "id", "type", "polygon", "height", "openings", "materials",
                   "light", "style", "palette"});
  Room room;
  room.id = json["id"].text_or("", 200);
  room.type = json["type"].text_or("", 200);
  room.height = json["height"].number_or(default_room_height, 1.5, 20.0);
  const auto points = read_corners(json["polygon"]);
  for (const auto& element : json["openings"].elements_or_none(max_openings))
    room.openings.push_back(read_opening(element));
  auto polygon = make_polygon(points);
  if (!polygon) {
    json["polygon"].report(polygon.error().message);
    return room;
  }
  room.polygon = *std::move(polygon);
  read_look(json, FileWalls(points, room.polygon), room);
  move_openings(room, points, json["openings"]);
  if (auto status = check(room); !status) json.report(status.error().message);
  return room;
}

Result<Room> read_room_file(const std::filesystem::path& path) {
  auto text = read_file(path);
  if (!text) return text.error();
  auto json = parse_json(*text, path.string());
  if (!json) return json.error();
  JsonReader::Problems problems(path.string());
  // A whole scene or plan serves as well: its room is taken.
  const JsonReader root(*json, problems);
  Room room = read_room(json->is_object() && json->contains("room") ? root["room"] : root);
  if (auto status = problems.all(); !status) return status.error();
  return room;
}

}  // namespace roomgen
