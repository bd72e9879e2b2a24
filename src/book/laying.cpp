#include "laying.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "roomgen/base/text.h"
#include "scene/wall_sides.h"
#include "seen_opening.h"

namespace roomgen::book {

namespace {

enum Wall { south, east, north, west };
template <typename Call>
void for_each_in(Json& object, const char* list, Call call) {
  if (!object.is_object() || !object.contains(list) || !object[list].is_array()) return;
  for (auto& one : object[list])
    if (one.is_object()) call(one);
}

/// Lays what is filled in into the room: mirrors, then turns.
class Laying {
 public:
  Laying(const std::string& source, const Setting& setting, const Vec2& size)
      : source_(source), setting_(setting), size_(size) {}

  Status run(Json& body) {
    const Json openings = body.value("openings", Json::array());
    Status status;
    for (const char* list : {"groups", "objects"})
      for_each_in(body, list, [&](Json& one) {
        if (one.contains("stands") && status) status = stand(one, openings);
        if (setting_.is_mirrored) mirror(one);
      });
    for_each_in(body, "openings", [&](Json& opening) { lay_opening(opening); });
    if (body.contains("room") && body["room"].contains("materials"))
      for_each_in(body["room"]["materials"], "walls",
                  [&](Json& cover) { cover["wall"] = laid_wall(cover.value("wall", Json())); });
    return status;
  }

 private:
  Error wrong(const std::string& what) const {
    return {Error::Kind::invalid_input, source_ + ": " + what};
  }

  Json laid_wall(const Json& name) const {
    const auto wall = name.is_string() ? compass_side(name.get<std::string>()) : std::nullopt;
    return wall ? Json(compass_name(laid(*wall))) : name;
  }
  int laid(int wall) const {
    if (setting_.is_mirrored && (wall == east || wall == west)) wall = east + west - wall;
    return (wall + setting_.turns) % 4;
  }
  Vec2 laid(Vec2 point) const {
    Vec2 size = size_;
    if (setting_.is_mirrored) point.x() = size.x() - point.x();
    for (int turn = 0; turn < setting_.turns; ++turn) {
      point = Vec2(size.y() - point.y(), point.x());
      std::swap(size.x(), size.y());
    }
    return point;
  }
  double laid(double yaw_deg) const {
    return (setting_.is_mirrored ? -yaw_deg : yaw_deg) + 90.0 * setting_.turns;
  }

  void lay_opening(Json& opening) const {
    opening["wall"] = laid_wall(opening.value("wall", Json()));
    if (setting_.is_mirrored && opening.contains("at") && opening["at"].is_number())
      opening["at"] = 1.0 - opening["at"].get<double>();
  }

  static double number_in(const Json& json, const char* key, double fallback) {
    return json.contains(key) && json[key].is_number() ? json[key].get<double>() : fallback;
  }
  static std::string text_in(const Json& json, const char* key) {
    return json.is_object() && json.contains(key) && json[key].is_string()
               ? json[key].get<std::string>()
               : std::string();
  }
  static double length_of(int wall, const Vec2& size) {
    return wall % 2 == 0 ? size.x() : size.y();
  }

  // `across` metres from the wall, `along` it from the west or south.
  Vec2 point_at(int wall, double along, double across) const {
    switch (wall) {
      case south:
        return {along, across};
      case north:
        return {along, size_.y() - across};
      case east:
        return {size_.x() - across, along};
      default:
        return {across, along};
    }
  }
  // Of what has its back at the wall: fronts look south at 0.
  static double yaw_at(int wall) {
    constexpr double yaws[] = {180.0, 270.0, 0.0, 90.0};
    return yaws[wall];
  }
  static std::optional<double> facing_in(const Json& stands) {
    const Json facing = stands.value("facing", Json());
    if (facing.is_number()) return facing.get<double>();
    const auto side = facing.is_string() ? compass_side(facing.get<std::string>()) : std::nullopt;
    return side ? std::optional(90.0 * *side) : std::nullopt;
  }

  // Half the width and half the depth of what stands there.
  static Vec2 half_of(const Json& one) {
    const Json* thing = &one;
    if (one.contains("things") && one["things"].is_array() && !one["things"].empty())
      thing = &one["things"].front();
    const Json size = thing->is_object() ? thing->value("size_cm", Json()) : Json();
    if (!size.is_array() || size.size() != 3 || !size[0].is_number() || !size[1].is_number())
      return {0.3, 0.3};
    return {size[0].get<double>() / 200.0, size[1].get<double>() / 200.0};
  }

  /// Where something stands in the design's frame.
  struct Spot {
    std::optional<Vec2> point;
    std::optional<double> yaw;  ///< degrees
    bool at_wall = false;
  };

  Status stand(Json& one, const Json& openings) {
    const std::string where = one.value("id", one.value("name", std::string("?"))) + "/stands";
    if (!one["stands"].is_object()) return wrong(where + ": an object is expected");
    const auto spot = spot_of(one["stands"], openings, half_of(one), where);
    if (!spot) return spot.error();
    one["stands"] = {{"wall", spot->at_wall}};
    if (spot->point) {
      const Vec2 first = laid(spot->point->cwiseMax(0.02).cwiseMin(size_ - Vec2(0.02, 0.02)));
      const Vec2 copy = spot->yaw ? to_first_copy(one, half_of(one), laid(*spot->yaw)) : Vec2(0, 0);
      one["stands"]["location"] = {first.x() + copy.x(), first.y() + copy.y()};
    }
    if (spot->yaw) one["stands"]["yaw_deg"] = laid(*spot->yaw);
    return {};
  }

  Result<Spot> spot_of(const Json& stands, const Json& openings, const Vec2& half,
                       const std::string& where) const {
    if (stands.contains("wall")) return at_wall(stands, half, where);
    if (stands.contains("corner")) return in_corner(stands, half, where);
    if (stands.contains("window") || stands.contains("door"))
      return at_opening(stands, openings, half);
    if (!stands.contains("at"))
      return wrong(where + ": say \"wall\", \"corner\", \"window\", \"door\" or \"at\"");
    const Json& at = stands["at"];
    if (!at.is_array() || at.size() != 2 || !at[0].is_number() || !at[1].is_number())
      return wrong(where + "/at: two numbers are expected");
    return Spot{Vec2(at[0].get<double>(), at[1].get<double>()), facing_in(stands), false};
  }

  Result<Spot> at_wall(const Json& stands, const Vec2& half, const std::string& where) const {
    const auto wall = compass_side(text_in(stands, "wall"));
    if (!wall) return wrong(where + "/wall: north, east, south or west is expected");
    const double along = number_in(stands, "along", 0.5 * length_of(*wall, size_));
    return Spot{point_at(*wall, along, half.y()), yaw_at(*wall), true};
  }

  // Of a grid `stands` tells the middle, if it is "centred", else the first copy: in the mirror
  // image of columns that is at their other end.
  Vec2 to_first_copy(const Json& one, const Vec2& half, double yaw_deg) const {
    const Json repeat = one.value("repeat", Json());
    if (!repeat.is_object()) return Vec2::Zero();
    const auto extent = [&](const char* number, const char* pitch, double side) {
      const double steps = std::max(1.0, std::round(number_in(repeat, number, 1.0))) - 1.0;
      return steps * number_in(repeat, pitch, side + 0.9);  // as a group of its own has it
    };
    const Vec2 last(extent("columns", "across_m", 2.0 * half.x()),
                    extent("rows", "along_m", 2.0 * half.y()));
    const Vec2 back = repeat.value("centred", false) ? Vec2(0.5 * last)
                      : setting_.is_mirrored         ? Vec2(last.x(), 0.0)
                                                     : Vec2::Zero();
    return rotated(-back, radians(yaw_deg));
  }

  Result<Spot> in_corner(const Json& stands, const Vec2& half, const std::string& where) const {
    const auto names = split(text_in(stands, "corner"), '-');
    const auto first = names.size() == 2 ? compass_side(names[0]) : std::nullopt;
    const auto second = names.size() == 2 ? compass_side(names[1]) : std::nullopt;
    if (!first || !second || *first % 2 != 0 || *second % 2 == 0)
      return wrong(where + "/corner: north-east or the like is expected");
    const double yaw = facing_in(stands).value_or(yaw_at(*first));
    const bool along_x = std::abs(std::fmod(yaw, 180.0)) < 1.0;
    const double x = along_x ? half.x() : half.y(), y = along_x ? half.y() : half.x();
    const Vec2 point(*second == east ? size_.x() - x : x, *first == north ? size_.y() - y : y);
    return Spot{point, yaw, true};
  }

  // Which of the doors or windows; in a room that lacks it, it likes any place.
  Spot at_opening(const Json& stands, const Json& openings, const Vec2& half) const {
    const bool at_window = stands.contains("window");
    const Json* opening =
        opening_of(openings, at_window, number_in(stands, at_window ? "window" : "door", 0.0));
    const auto wall = opening ? compass_side(text_in(*opening, "wall")) : std::nullopt;
    if (!wall) return {std::nullopt, facing_in(stands), false};
    const double length = length_of(*wall, size_);
    // Openings are told along the walls counter-clockwise, things from the west and south.
    const double part = number_in(*opening, "at", 0.5);
    double along = length * (*wall == north || *wall == west ? 1.0 - part : part);
    if (const std::string beside = text_in(stands, "beside"); !beside.empty()) {
      const double off = 0.5 * number_in(*opening, "width", 1.0) + half.x() + 0.12;
      // Who looks at the south wall from inside has the east at the left, at the east wall the
      // north.
      along += (*wall == south || *wall == east) == (beside == "left") ? off : -off;
    }
    const double margin = std::min(half.x(), 0.5 * length);
    const auto facing = facing_in(stands);
    return {point_at(*wall, std::clamp(along, margin, length - margin), half.y()),
            facing.value_or(yaw_at(*wall)), !facing};
  }

  static const Json* opening_of(const Json& openings, bool is_wanted, double number) {
    for (const auto& opening : openings) {
      if (is_window(opening) == is_wanted && number-- < 0.5) return &opening;
    }
    return nullptr;
  }

  // Left and right of the things in a group change places.
  static void mirror(Json& one) {
    for_each_in(one, "things", [](Json& thing) {
      if (thing.contains("at_m") && thing["at_m"].is_array() && !thing["at_m"].empty() &&
          thing["at_m"][0].is_number())
        thing["at_m"][0] = -thing["at_m"][0].get<double>();
      if (thing.contains("facing") && thing["facing"].is_number())
        thing["facing"] = -thing["facing"].get<double>();
      if (thing.contains("where") && thing["where"].is_string())
        thing["where"] = swapped(thing["where"]);
    });
    if (one.contains("with") && one["with"].is_object())
      for (auto& value : one["with"])
        if (value.is_string()) value = swapped(value);
  }
  static std::string swapped(const std::string& text) {
    if (text.starts_with("left")) return "right" + text.substr(4);
    if (text.starts_with("right")) return "left" + text.substr(5);
    return text;
  }

  const std::string& source_;
  const Setting& setting_;
  Vec2 size_;
};

}  // namespace

Status lay(const std::string& source, const Setting& setting, const Vec2& size, Json& answer) {
  return Laying(source, setting, size).run(answer);
}

}  // namespace roomgen::book
