#include <algorithm>
#include <nlohmann/json.hpp>

#include "limits.h"
#include "read_set.h"
#include "scene/document_parts.h"

namespace roomgen::lab {

namespace {

constexpr double least_height = 1.5, greatest_height = 20.0;

std::string room_type(const JsonReader& json) {
  std::string type = json.text(program_limits::name_bytes);
  std::replace(type.begin(), type.end(), '-', ' ');
  return type;
}

void read_outline(const JsonReader& json, ProgramRoom& wish) {
  json.allow_only({"type", "polygon", "height", "openings"});
  const Room room = read_room(json);
  wish.polygon = room.polygon;
  if (json["openings"].exists()) wish.openings = room.openings;
}

bool is_fixed(const std::optional<Range>& range) { return range && range->low == range->high; }

// The openings of a rectangle, whose walls run from the origin along the width.
void read_rectangle_openings(const JsonReader& json, ProgramRoom& wish) {
  if (!json.exists()) return;
  if (!is_fixed(wish.width) || !is_fixed(wish.depth))
    return json.report("openings need walls of a known length: give a polygon, or width and depth as numbers");
  const double width = wish.width->low, depth = wish.depth->low;
  const Json document = {{"type", wish.type},
                         {"polygon", {{0.0, 0.0}, {width, 0.0}, {width, depth}, {0.0, depth}}},
                         {"openings", *json.raw()}};
  JsonReader::Problems problems("room");
  wish.openings = read_room(JsonReader(document, problems)).openings;
  if (problems.first()) json.report(problems.first()->message);
}

void read_size(const JsonReader& json, ProgramRoom& wish) {
  json.allow_only({"type", "width", "depth", "area", "height", "openings"});
  const auto side = [&](const char* key) -> std::optional<Range> {
    if (!json[key].exists()) return std::nullopt;
    return read_program_range(json[key], least_room_side, greatest_room_side);
  };
  wish.width = side("width");
  wish.depth = side("depth");
  if (const auto area = json["area"]; area.exists())
    wish.area = read_program_range(area, least_room_side * least_room_side, greatest_room_side * greatest_room_side);
  if (wish.area && (wish.width || wish.depth)) json.report("give width and depth, or an area");
  if (wish.width.has_value() != wish.depth.has_value()) json.report("give both width and depth");
  read_rectangle_openings(json["openings"], wish);
}

}  // namespace

Range read_program_range(const JsonReader& json, double low, double high) {
  if (!json.is_array()) {
    const double value = json.number(low, high);
    return {value, value};
  }
  const auto ends = json.numbers(2, low, high);
  return {ends[0], ends[1]};
}

ProgramRoom read_room_wish(const JsonReader& json) {
  ProgramRoom wish;
  wish.type = room_type(json["type"]);
  if (!json.is_object()) return wish;
  if (json["height"].exists()) wish.height = json["height"].number(least_height, greatest_height);
  if (json["polygon"].exists()) read_outline(json, wish);
  else read_size(json, wish);
  return wish;
}

}  // namespace roomgen::lab
