#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "design.h"
#include "palette.h"
#include "roomgen/base/text.h"

namespace roomgen::book {

namespace {

// Members whose values are numbers, or lists of numbers: there a text is a formula.
const std::set<std::string, std::less<>> number_members = {
    "size_cm", "quantity", "gap_m",    "at_m",    "bottom_m", "lean_deg", "value",
    "rows",    "columns",  "across_m", "along_m", "at",       "along",    "width",
    "sill",    "head",     "height_m", "height",  "when",     "number",   "hour"};

enum Wall { south, east, north, west };
constexpr const char* wall_names[] = {"south", "east", "north", "west"};

std::optional<int> wall_named(std::string_view name) {
  for (int wall = south; wall <= west; ++wall)
    if (name == wall_names[wall]) return wall;
  return std::nullopt;
}

Error wrong(const std::string& where, const std::string& what) {
  return {Error::Kind::invalid_input, where + ": " + what};
}

/// Puts numbers in the place of formulas and words in the place of the palette's roles.
class Filling {
 public:
  Filling(const Design& design, const Values& values, const Json& palette)
      : source_(design.source),
        scope_{values, {}, 0},
        palette_(palette),
        programs_(design.programs) {}

  std::optional<Error> first_error() const { return error_; }

  // `is_number`: it is the value of a number's member, or stands in its list.
  Json filled(const Json& json, const std::string& pointer, bool is_number) {
    if (json.is_string()) return is_number ? number(json, pointer) : Json(worded(json));
    if (!json.is_structured()) return json;
    Json result = json.is_array() ? Json::array() : Json::object();
    for (const auto& [key, value] : json.items()) {
      const std::string inner = pointer + "/" + key;
      if (json.is_array()) {
        if (is_there(value, inner)) result.push_back(filled(value, inner, is_number));
      } else if (key == "program") {
        result[key] = program(value, inner);
      } else if (key == "with" && value.is_object()) {
        result[key] = settings(value, inner);
      } else if (key != "when") {
        result[key] = filled(value, inner, number_members.count(key) > 0);
      }
    }
    return result;
  }

 private:
  bool is_there(const Json& value, const std::string& pointer) {
    if (!value.is_object() || !value.contains("when")) return true;
    const Json truth =
        value["when"].is_string() ? number(value["when"], pointer + "/when") : value["when"];
    return !truth.is_number() || truth.get<double>() != 0.0;
  }

  Json number(const Json& text, const std::string& pointer) {
    const auto formula = Expression::compile(text.get<std::string>());
    const auto value = formula ? formula->number(scope_) : Result<double>(formula.error());
    if (value) return *value;
    if (!error_) error_ = wrong(source_, pointer + ": " + value.error().message);
    return 0.0;
  }

  // A shape program, or the name of one of the design's.
  Json program(const Json& said, const std::string& pointer) {
    if (!said.is_string()) return only_worded(said, false);
    const auto known = programs_.find(said.get<std::string>());
    if (known != programs_.end()) return only_worded(*known, false);
    if (!error_)
      error_ =
          wrong(source_, pointer + ": \"" + said.get<std::string>() + "\" is none of \"programs\"");
    return Json();
  }

  // Programs have formulas of their own, and know fewer colours than people.
  Json only_worded(const Json& json, bool is_color) const {
    if (json.is_string()) return is_color ? program_color(worded(json)) : worded(json);
    if (!json.is_structured()) return json;
    Json result = json;
    for (const auto& [key, value] : json.items()) {
      Json inner = only_worded(value, key == "color");
      if (json.is_array())
        result[std::stoul(key)] = std::move(inner);
      else
        result[key] = std::move(inner);
    }
    return result;
  }

  // Choices of a composition are words.
  Json settings(const Json& with, const std::string&) {
    Json result = Json::object();
    for (const auto& [key, value] : with.items()) {
      const auto formula = value.is_string() ? Expression::compile(value.get<std::string>())
                                             : Result<Expression>(Error{});
      const auto number = formula ? formula->number(scope_) : Result<double>(Error{});
      result[key] = number ? Json(*number) : value;
    }
    return result;
  }

  std::string worded(const Json& json) const {
    std::string text = json.get<std::string>();
    for (std::size_t open = text.find('{'); open != std::string::npos;
         open = text.find('{', open)) {
      const std::size_t close = text.find('}', open);
      if (close == std::string::npos) break;
      const std::string role = text.substr(open + 1, close - open - 1);
      const std::string word =
          palette_.is_object() ? palette_.value(role, std::string()) : std::string();
      text.replace(open, close - open + 1, word);
      open += word.size();
    }
    return text;
  }

  std::string source_;
  shape::Scope scope_;
  const Json& palette_;
  const Json& programs_;
  std::optional<Error> error_;
};

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
  Json laid_wall(const Json& name) const {
    const auto wall = name.is_string() ? wall_named(name.get<std::string>()) : std::nullopt;
    return wall ? Json(wall_names[laid(*wall)]) : name;
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
  static std::optional<double> yaw_towards(const Json& facing) {
    if (facing.is_number()) return facing.get<double>();
    const auto side = facing.is_string() ? wall_named(facing.get<std::string>()) : std::nullopt;
    return side ? std::optional(90.0 * *side) : std::nullopt;
  }

  // Half the depth and half the width of what stands there.
  static Vec2 half_of(const Json& one) {
    const Json* thing = &one;
    if (one.contains("things") && one["things"].is_array() && !one["things"].empty())
      thing = &one["things"].front();
    const Json size = thing->is_object() ? thing->value("size_cm", Json()) : Json();
    if (!size.is_array() || size.size() != 3 || !size[0].is_number() || !size[1].is_number())
      return {0.3, 0.3};
    return {size[0].get<double>() / 200.0, size[1].get<double>() / 200.0};
  }

  Status stand(Json& one, const Json& openings) {
    const Json stands = one["stands"];
    const std::string where = one.value("id", one.value("name", std::string("?"))) + "/stands";
    if (!stands.is_object()) return wrong(source_, where + ": an object is expected");
    const Vec2 half = half_of(one);
    std::optional<Vec2> point;
    std::optional<double> yaw = yaw_towards(stands.value("facing", Json()));
    bool at_wall = false;
    if (stands.contains("wall")) {
      const auto wall =
          wall_named(stands["wall"].is_string() ? stands["wall"].get<std::string>() : "");
      if (!wall) return wrong(source_, where + "/wall: north, east, south or west is expected");
      point = point_at(*wall, number_in(stands, "along", 0.5 * length_of(*wall, size_)), half.y());
      yaw = yaw_at(*wall), at_wall = true;
    } else if (stands.contains("corner")) {
      if (auto status = in_corner(stands, half, where, point, yaw); !status) return status;
      at_wall = true;
    } else if (stands.contains("window") || stands.contains("door")) {
      at_opening(stands, openings, half, point, yaw, at_wall);
    } else if (stands.contains("at")) {
      const Json& at = stands["at"];
      if (!at.is_array() || at.size() != 2 || !at[0].is_number() || !at[1].is_number())
        return wrong(source_, where + "/at: two numbers are expected");
      point = Vec2(at[0].get<double>(), at[1].get<double>());
    } else {
      return wrong(source_, where + ": say \"wall\", \"corner\", \"window\", \"door\" or \"at\"");
    }
    one["stands"] = {{"wall", at_wall}};
    if (point) {
      const Vec2 first = laid(point->cwiseMax(0.02).cwiseMin(size_ - Vec2(0.02, 0.02)));
      const Vec2 inside = yaw ? first + to_first_copy(one, half, laid(*yaw)) : first;
      one["stands"]["location"] = {inside.x(), inside.y()};
    }
    if (yaw) one["stands"]["yaw_deg"] = laid(*yaw);
    return {};
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

  Status in_corner(const Json& stands, const Vec2& half, const std::string& where,
                   std::optional<Vec2>& point, std::optional<double>& yaw) const {
    const auto names =
        split(stands["corner"].is_string() ? stands["corner"].get<std::string>() : "", '-');
    const auto first = names.size() == 2 ? wall_named(names[0]) : std::nullopt;
    const auto second = names.size() == 2 ? wall_named(names[1]) : std::nullopt;
    if (!first || !second || *first % 2 != 0 || *second % 2 == 0)
      return wrong(source_, where + "/corner: north-east or the like is expected");
    if (!yaw) yaw = yaw_at(*first);
    const bool along_x = std::abs(std::fmod(*yaw, 180.0)) < 1.0;
    const double x = along_x ? half.x() : half.y(), y = along_x ? half.y() : half.x();
    point = Vec2(*second == east ? size_.x() - x : x, *first == north ? size_.y() - y : y);
    return {};
  }

  // Which of the doors or windows; in a room that lacks it, it likes any place.
  void at_opening(const Json& stands, const Json& openings, const Vec2& half,
                  std::optional<Vec2>& point, std::optional<double>& yaw, bool& at_wall) const {
    const bool is_window = stands.contains("window");
    const double wanted = number_in(stands, is_window ? "window" : "door", 0.0);
    double number = 0.0;
    for (const auto& opening : openings) {
      if ((opening.value("kind", std::string()).find("window") != std::string::npos) != is_window)
        continue;
      if (number++ != wanted) continue;
      const auto wall = wall_named(opening.value("wall", std::string()));
      if (!wall) return;
      const double length = length_of(*wall, size_);
      // Openings are told along the walls counter-clockwise, things from the west and south.
      const double part = number_in(opening, "at", 0.5);
      double along = length * (*wall == north || *wall == west ? 1.0 - part : part);
      if (stands.contains("beside") && stands["beside"].is_string()) {
        const double off = 0.5 * number_in(opening, "width", 1.0) + half.x() + 0.12;
        // Who looks at the south wall from inside has the east at the left, at the east wall the
        // north.
        const bool is_towards_end =
            (*wall == south || *wall == east) == (stands["beside"] == "left");
        along += is_towards_end ? off : -off;
      }
      const double margin = std::min(half.x(), 0.5 * length);
      point = point_at(*wall, std::clamp(along, margin, length - margin), half.y());
      if (!yaw) yaw = yaw_at(*wall), at_wall = true;
      return;
    }
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

Result<Json> answer_of(const Design& design, const Setting& setting) {
  Vec2 size = setting.size;
  if (setting.turns % 2 != 0) std::swap(size.x(), size.y());
  Values values = setting.values;
  values["W"] = size.x(), values["D"] = size.y(), values["H"] = setting.height;
  Filling filling(design, values, setting.palette);
  Json body = setting.openings.is_array() ? design.body : Json();
  if (setting.openings.is_array()) body["openings"] = setting.openings;
  Json answer = filling.filled(setting.openings.is_array() ? body : design.body, "", false);
  if (const auto error = filling.first_error()) return *error;
  if (auto status = Laying(design.source, setting, size).run(answer); !status)
    return status.error();
  Json& room = answer["room"];
  if (room.is_null()) room = Json::object();
  room["size_m"] = {setting.size.x(), setting.size.y()};
  room["palette"] = setting.palette.is_object() ? setting.palette : Json::object();
  return answer;
}

}  // namespace roomgen::book
