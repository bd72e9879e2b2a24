#include "wanted_opening_json.h"

#include <nlohmann/json.hpp>

#include "file_limits.h"
#include "file_walls.h"
#include "geometry/triangulate.h"
#include "opening_kind.h"
#include "room_look_json.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "wall_sides.h"

namespace roomgen {

namespace {

constexpr std::size_t max_wanted = 200;
constexpr double least_width = 0.1, greatest_height = 20.0;

void remark_on_kind(const JsonReader& json, const std::string& kind) {
  if (kind.empty()) return json.remark("is missing, as in \"window\"; left out");
  const auto& known = OpeningKinds::built_in();
  if (!known || known->find(kind)) return;
  std::vector<std::string> names;
  for (const auto& [name, entry] : known->all()) names.push_back(name);
  const std::string close = closest_name(kind, names);
  json.remark("\"" + kind + "\" is no kind of opening that is known" +
              (close.empty() ? "" : "; did you mean \"" + close + "\"?") + "; left out");
}

/// Walls of the file, and those that the room has of them.
class WallsOfFile {
 public:
  WallsOfFile(const std::vector<Vec2>& corners, const Room& room)
      : corners_(corners), room_(room), names_(corners, room.polygon) {}

  void take(const JsonReader& json, WantedOpening& opening) const {
    const auto wall = json.exists() ? read_wall(json) : std::nullopt;
    if (wall && *wall != accent_name) opening.wall = *wall;
    const bool is_told = opening.wall.empty() || is_wall(opening.wall);
    if (!is_told) {
      json.remark("\"" + opening.wall + "\" is no wall of a room of " +
                  std::to_string(corners_.size()) + "; any wall will do");
      opening.wall.clear();
    }
    if (opening.wall.empty()) opening.at = opening.offset = std::nullopt;
    if (opening.at || opening.offset) move(opening);
  }

 private:
  bool is_wall(const std::string& name) const {
    for (std::size_t k = 0; k < corners_.size(); ++k)
      if (name == "wall-" + std::to_string(k)) return true;
    return !name.starts_with("wall-") && is_wall_name(name);
  }

  // The place along the room's wall of one along the file's.
  void move(WantedOpening& opening) const {
    const std::string said = opening.wall;
    names_.rename(opening.wall);
    if (corners_ == room_.polygon.points) return;
    if (!said.starts_with("wall-")) {
      if (signed_area(corners_) > 0.0) return;
      if (opening.at) opening.at = 1.0 - *opening.at;
      if (opening.offset) opening.offset = -*opening.offset;
      return;
    }
    const std::size_t k = std::stoul(said.substr(5));
    const Segment told{corners_[k], corners_[(k + 1) % corners_.size()]};
    const Vec2 middle = opening.at ? Vec2(told.a + *opening.at * (told.b - told.a))
                                   : Vec2(told.middle() + *opening.offset * told.direction());
    const Segment wall = room_.polygon.edge(walls_named(room_, opening.wall).front());
    opening.at.reset();
    opening.offset = (middle - wall.middle()).dot(wall.direction());
  }

  const std::vector<Vec2>& corners_;
  const Room& room_;
  FileWalls names_;
};

WantedOpening read_wanted(const JsonReader& json) {
  json.allow_only({"kind", "wall", "at", "offset", "width", "sill", "head", "for"});
  WantedOpening opening;
  opening.kind = lower(json["kind"].text(200));
  opening.at = read_within(json["at"], 0.0, 1.0);
  opening.offset = read_within(json["offset"], -max_coordinate, max_coordinate);
  opening.width = read_within(json["width"], least_width, max_coordinate);
  opening.sill = read_within(json["sill"], 0.0, greatest_height);
  opening.head = read_within(json["head"], 0.0, greatest_height);
  opening.purpose = json["for"].text_or("", 1000);
  if (opening.at && opening.offset) {
    json["offset"].remark("there is an \"at\" too, which counts");
    opening.offset.reset();
  }
  return opening;
}

Json wanted_json(const WantedOpening& opening) {
  Json json;
  json["kind"] = opening.kind;
  if (!opening.wall.empty()) json["wall"] = opening.wall;
  const auto add = [&](const char* key, const std::optional<double>& value) {
    if (value) json[key] = rounded(*value);
  };
  add("at", opening.at);
  add("offset", opening.offset);
  add("width", opening.width);
  add("sill", opening.sill);
  add("head", opening.head);
  if (!opening.purpose.empty()) json["for"] = opening.purpose;
  return json;
}

}  // namespace

std::vector<WantedOpening> read_wanted_openings(const JsonReader& json,
                                                const std::vector<Vec2>& corners,
                                                const Room& room) {
  std::vector<WantedOpening> openings;
  const WallsOfFile walls(corners, room);
  for (const auto& element : json.elements_or_none(max_wanted)) {
    WantedOpening opening = read_wanted(element);
    remark_on_kind(element["kind"], opening.kind);
    walls.take(element["wall"], opening);
    openings.push_back(std::move(opening));
  }
  return openings;
}

Json to_json(const std::vector<WantedOpening>& openings) {
  Json json = Json::array();
  for (const auto& opening : openings) json.push_back(wanted_json(opening));
  return json;
}

}  // namespace roomgen
