#include "room_look_json.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "file_limits.h"
#include "finish.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "wall_sides.h"

namespace roomgen {

namespace {

constexpr std::size_t max_covers = 500, max_lamps = 1000, max_style_words = 50;
constexpr double highest_band = 20.0, brightest = 200000.0, coldest = 40000.0, warmest = 500.0;

WallBand read_band(const JsonReader& json) {
  json.allow_only({"finish", "height"});
  return {json["finish"].text_or(""), json["height"].number(0.0, highest_band)};
}

void read_cover(const JsonReader& json, RoomMaterials& materials) {
  json.allow_only({"wall", "finish", "lower"});
  const bool is_of_all = !json["wall"].exists();
  const auto wall = is_of_all ? std::string() : read_wall(json["wall"]);
  if (!wall) return;
  std::optional<WallBand> lower;
  if (json["lower"].exists()) lower = read_band(json["lower"]);
  const std::string finish = json["finish"].text_or("");
  if (!is_of_all) {
    materials.covers.push_back({*wall, finish, lower});
    return;
  }
  materials.walls = finish;
  if (lower) materials.covers.insert(materials.covers.begin(), WallCover{"", "", lower});
}

RoomMaterials read_materials(const JsonReader& json, const FileWalls& walls) {
  RoomMaterials materials;
  if (!json.exists()) return materials;
  json.allow_only({"floor", "walls", "ceiling", "accent"});
  materials.floor = json["floor"].text_or("");
  materials.ceiling = json["ceiling"].text_or("");
  if (json["walls"].is_array())
    for (const auto& element : json["walls"].elements(max_covers)) read_cover(element, materials);
  else
    materials.walls = json["walls"].text_or("");
  for (auto& cover : materials.covers) walls.rename(cover.wall);
  // What files said of one wall before walls had covers.
  if (const std::string said = json["accent"].text_or(""); !said.empty())
    cover_named(materials, accent_name).finish = said;
  return materials;
}

void drop_unknown_walls(const JsonReader& json, Room& room) {
  std::erase_if(room.materials.covers, [&](const WallCover& cover) {
    const bool is_none = !cover.wall.empty() && walls_named(room, cover.wall).empty();
    if (is_none)
      json.remark("\"" + cover.wall + "\" is no wall of a room of " +
                  std::to_string(room.polygon.size()) + "; left out");
    return is_none;
  });
}

Json cover_json(const WallCover& cover) {
  Json json = Json::object();
  if (!cover.wall.empty()) json["wall"] = cover.wall;
  if (!cover.finish.empty()) json["finish"] = cover.finish;
  if (!cover.lower) return json;
  if (!cover.lower->finish.empty()) json["lower"]["finish"] = cover.lower->finish;
  json["lower"]["height"] = rounded(cover.lower->height);
  return json;
}

Json walls_json(const RoomMaterials& materials) {
  WallCover others{"", materials.walls, {}};
  Json list = Json::array();
  for (const auto& cover : materials.covers)
    if (cover.wall.empty())
      others.lower = cover.lower;
    else
      list.push_back(cover_json(cover));
  if (!others.finish.empty() || others.lower) list.insert(list.begin(), cover_json(others));
  return list;
}

void add_materials(Json& json, const RoomMaterials& materials) {
  Json said = Json::object();
  if (!materials.floor.empty()) said["floor"] = materials.floor;
  if (!materials.covers.empty())
    said["walls"] = walls_json(materials);
  else if (!materials.walls.empty())
    said["walls"] = materials.walls;
  if (!materials.ceiling.empty()) said["ceiling"] = materials.ceiling;
  if (!said.empty()) json["materials"] = said;
}

// A number, or one of the words for it.
std::optional<double> read_measure(const JsonReader& json, double low, double high,
                                   const FinishWords::Words<double>& words) {
  if (!json.is_string()) return read_within(json, low, high);
  const std::string word = lower(json.text());
  if (const auto found = words.find(word); found != words.end()) return found->second;
  // "1900", "1900 K"
  double value = 0.0;
  const auto figures = std::from_chars(word.data(), word.data() + word.size(), value);
  if (figures.ec == std::errc() && value >= low && value <= high) return value;
  std::string known;
  for (const auto& [name, value] : words) known += (known.empty() ? "" : ", ") + name;
  json.remark("\"" + word + "\" is none of " + known + "; left open");
  return std::nullopt;
}

std::optional<Sky> read_sky(const JsonReader& json) {
  if (!json.exists()) return std::nullopt;
  const std::string word = lower(json.text());
  const auto& skies = finish_words().skies;
  if (const auto found = skies.find(word); found != skies.end()) return found->second;
  json.remark("\"" + word + "\" is none of clear, cloudy, overcast, night; left open");
  return std::nullopt;
}

std::optional<std::vector<std::string>> read_lamps(const JsonReader& json) {
  if (!json.exists()) return std::nullopt;
  std::vector<std::string> lamps;
  if (json.is_array())
    for (const auto& element : json.elements(max_lamps)) lamps.push_back(lower(element.text(200)));
  else if (const std::string said = lower(json.text(200)); said != "none")
    lamps.push_back(said);
  return lamps;
}

Lighting read_room_light(const JsonReader& json) {
  if (!json.exists()) return {};
  json.allow_only({"hour", "sky", "level", "warmth", "lamps"});
  return read_light(json);
}

}  // namespace

Lighting read_light(const JsonReader& json) {
  Lighting light;
  light.hour = read_within(json["hour"], 0.0, 24.0);
  light.sky = read_sky(json["sky"]);
  light.lux = read_measure(json["level"], 0.0, brightest, finish_words().levels);
  light.kelvin = read_measure(json["warmth"], warmest, coldest, finish_words().warmths);
  light.lamps = read_lamps(json["lamps"]);
  return light;
}

Json light_json(const Lighting& light) {
  Json said = Json::object();
  if (light.hour) said["hour"] = rounded(*light.hour);
  if (light.sky) said["sky"] = name(*light.sky);
  if (light.lux) said["level"] = rounded(*light.lux);
  if (light.kelvin) said["warmth"] = rounded(*light.kelvin);
  if (light.lamps) said["lamps"] = *light.lamps;
  return said;
}

namespace {

std::vector<std::string> read_style(const JsonReader& json) {
  std::vector<std::string> style;
  if (json.is_string()) return {json.text()};
  for (const auto& element : json.elements_or_none(max_style_words))
    style.push_back(element.text());
  return style;
}

std::map<std::string, std::string, std::less<>> read_palette(const JsonReader& json) {
  std::map<std::string, std::string, std::less<>> palette;
  for (const auto& [role, said] : json.members()) {
    const std::string color = said.text(200);
    const bool is_role = std::find(std::begin(palette_roles), std::end(palette_roles), role) !=
                         std::end(palette_roles);
    if (!is_role)
      said.remark("\"" + role +
                  "\" is no part of a palette; main, second, accent, wood and metal are; left out");
    else if (!says_finish(color))
      said.remark("\"" + color + "\" is no colour or stuff that is known; left out");
    else
      palette[role] = color;
  }
  return palette;
}

void remark_on_finish(const JsonReader& json) {
  const std::string said = json.is_string() ? json.text() : "";
  if (!said.empty() && !says_finish(said))
    json.remark("\"" + said +
                "\" names no colour or material that is known; the usual one is drawn");
}

}  // namespace

void read_look(const JsonReader& json, const FileWalls& walls, Room& room) {
  room.materials = read_materials(json["materials"], walls);
  drop_unknown_walls(json["materials"]["walls"], room);
  room.light = read_room_light(json["light"]);
  room.style = read_style(json["style"]);
  room.palette = read_palette(json["palette"]);
}

void add_look(Json& json, const Room& room) {
  add_materials(json, room.materials);
  if (Json light = light_json(room.light); !light.empty()) json["light"] = std::move(light);
  if (!room.style.empty()) json["style"] = room.style;
  if (!room.palette.empty()) json["palette"] = room.palette;
}

std::optional<std::string> read_wall(const JsonReader& json) {
  const bool is_number = json.raw()->is_number_integer();
  const std::string name = is_number ? "wall-" + std::to_string(json.integer_or(0, 0, 1'000'000))
                                     : lower(json.text(200));
  if (is_wall_name(name)) return name;
  json.remark(
      "\"" + name +
      "\" is no wall; a number, \"wall-2\", north, east, south, west and accent are; left out");
  return std::nullopt;
}

void remark_on_finishes(const JsonReader& materials) {
  if (!materials.is_object()) return;
  for (const char* part : {"floor", "ceiling", "walls", "accent"})
    remark_on_finish(materials[part]);
  if (!materials["walls"].is_array()) return;
  for (const auto& cover : materials["walls"].elements(max_covers)) {
    if (!cover.is_object()) continue;
    remark_on_finish(cover["finish"]);
    if (cover["lower"].is_object()) remark_on_finish(cover["lower"]["finish"]);
  }
}

std::optional<double> read_within(const JsonReader& json, double low, double high) {
  if (!json.exists()) return std::nullopt;
  const double value = json.number(-1e12, 1e12);
  if (value >= low && value <= high) return value;
  json.remark(format_number(value) + " is not from " + format_number(low) + " to " +
              format_number(high) + "; left open");
  return std::nullopt;
}

}  // namespace roomgen
