#include "solid_json.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "base/json_values.h"
#include "drawing.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen::shape::detail {

namespace {

constexpr int max_holes = 64;
constexpr int max_levels = 256;
constexpr int max_sides = 128;
constexpr int max_picture_seed = 1'000'000'000;

// Reading, one function a solid.

Solid read_box(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"size", "bevel"});
  return Box{numbers.size3(json["size"]), numbers.length_or_zero(json["bevel"], 0.0)};
}

Solid read_cylinder(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"radius", "height", "bevel"});
  const double radius = numbers.length(json["radius"]);
  return Frustum{radius, radius, numbers.length(json["height"]),
                 numbers.length_or_zero(json["bevel"], 0.0)};
}

double radius_or_tip(const JsonReader& json, const Numbers& numbers) {
  return numbers.number(json, 0.0, greatest_length);
}

Solid read_frustum(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"bottom_radius", "top_radius", "height", "bevel"});
  return Frustum{radius_or_tip(json["bottom_radius"], numbers),
                 radius_or_tip(json["top_radius"], numbers), numbers.length(json["height"]),
                 numbers.length_or_zero(json["bevel"], 0.0)};
}

Solid read_ellipsoid(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"size"});
  return Ellipsoid{numbers.size3(json["size"])};
}

Solid read_prism(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"sides", "radius", "bottom_radius", "top_radius", "height"});
  Prism prism;
  prism.sides = numbers.whole(json["sides"], 3, max_sides);
  if (json["radius"].exists()) {
    if (json["bottom_radius"].exists() || json["top_radius"].exists())
      json.report(
          "\"radius\" stands for both \"bottom_radius\" and \"top_radius\"; give one or the other");
    prism.bottom_radius = prism.top_radius = numbers.length(json["radius"]);
  } else {
    prism.bottom_radius = radius_or_tip(json["bottom_radius"], numbers);
    prism.top_radius = radius_or_tip(json["top_radius"], numbers);
  }
  prism.height = numbers.length(json["height"]);
  return prism;
}

Solid read_plane(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"size", "thickness"});
  return Plane{numbers.size2(json["size"]),
               numbers.number_or(json["thickness"], 0.002, least_length, greatest_length)};
}

Solid read_lathe(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"profile", "corners", "closed", "angle"});
  Lathe lathe;
  lathe.profile =
      read_curve2(json, numbers, "profile", "corners", json["closed"].boolean_or(false));
  for (const auto& point : lathe.profile.points)
    if (point.x() < 0.0) json["profile"].report("a radius is negative");
  lathe.angle = numbers.angle_or(json["angle"], 360.0, 1.0, 360.0);
  return lathe;
}

std::variant<Disc, Rectangle, Curve<Vec2>> read_section(const JsonReader& json,
                                                        const Numbers& numbers) {
  const int given = static_cast<int>(json["radius"].exists()) + json["section"].exists() +
                    json["outline"].exists();
  if (given != 1) json.report("expected one of \"radius\", \"section\" and \"outline\"");
  if (json["bevel"].exists() && !json["section"].exists())
    json["bevel"].report("\"bevel\" belongs to \"section\"");
  if (json["outline_corners"].exists() && !json["outline"].exists())
    json["outline_corners"].report("\"outline_corners\" belongs to \"outline\"");
  if (json["section"].exists())
    return Rectangle{numbers.size2(json["section"]), numbers.length_or_zero(json["bevel"], 0.0)};
  if (json["outline"].exists())
    return read_curve2(json, numbers, "outline", "outline_corners", true);
  return Disc{json["radius"].exists() ? numbers.length(json["radius"]) : 0.01};
}

Solid read_sweep(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"path", "corners", "closed", "radius", "section", "bevel", "outline",
                   "outline_corners", "taper", "twist"});
  SweptPart sweep;
  sweep.path = read_curve3(json, numbers, "path", "corners", json["closed"].boolean_or(false));
  sweep.section = read_section(json, numbers);
  sweep.taper = numbers.number_or(json["taper"], 1.0, 0.0, 100.0);
  sweep.twist = numbers.angle_or(json["twist"], 0.0, -max_degrees, max_degrees);
  return sweep;
}

Solid read_extrude(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"outline", "corners", "holes", "height", "bevel"});
  Extrusion extrusion;
  extrusion.outline = read_curve2(json, numbers, "outline", "corners", true);
  for (const auto& hole : json["holes"].elements_or_none(max_holes)) {
    hole.allow_only({"outline", "corners"});
    extrusion.holes.push_back(read_curve2(hole, numbers, "outline", "corners", true));
  }
  extrusion.height = numbers.length(json["height"]);
  extrusion.bevel = numbers.length_or_zero(json["bevel"], 0.0);
  return extrusion;
}

LoftedPart::Level read_level(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"z", "outline", "corners", "size", "round"});
  LoftedPart::Level level;
  level.z = numbers.number(json["z"], -greatest_length, greatest_length);
  if (json["outline"].exists() == json["size"].exists())
    json.report("expected one of \"outline\" and \"size\"");
  if (json["outline"].exists()) {
    if (json["round"].exists()) json["round"].report("\"round\" belongs to \"size\"");
    level.outline = read_curve2(json, numbers, "outline", "corners", true);
  } else {
    if (json["corners"].exists()) json["corners"].report("\"corners\" belongs to \"outline\"");
    level.outline =
        RoundedSize{numbers.size2(json["size"]), numbers.number_or(json["round"], 0.0, 0.0, 1.0)};
  }
  return level;
}

Solid read_loft(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"levels", "straight"});
  LoftedPart loft;
  for (const auto& level : json["levels"].elements(max_levels))
    loft.levels.push_back(read_level(level, numbers));
  if (json["levels"].is_array() && loft.levels.size() < 2)
    json["levels"].report("expected two levels or more");
  for (std::size_t i = 1; i < loft.levels.size(); ++i)
    if (loft.levels[i].z <= loft.levels[i - 1].z)
      json["levels"].report("level " + std::to_string(i) + " is not above the one before it");
  loft.straight = json["straight"].boolean_or(false);
  return loft;
}

Solid read_height_field(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"size", "height", "divisions", "least", "most"});
  HeightPart field;
  field.size = numbers.size2(json["size"]);
  field.height = numbers.height(json["height"]);
  field.divisions = numbers.whole_or(json["divisions"], 24, 2, 128);
  field.least = numbers.number_or(json["least"], 0.002, least_length, greatest_length);
  field.most = numbers.number_or(json["most"], 5.0, least_length, greatest_length);
  if (field.least > field.most) json["least"].report("\"least\" is above \"most\"");
  return field;
}

Solid read_leaf(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"length", "width", "thickness", "bend", "fold", "widest"});
  Leaf leaf;
  leaf.length = numbers.length(json["length"]);
  leaf.width = numbers.length(json["width"]);
  leaf.thickness = numbers.number_or(json["thickness"], 0.001, least_length, greatest_length);
  leaf.bend = numbers.angle_or(json["bend"], 0.0, -180.0, 180.0);
  leaf.fold = numbers.angle_or(json["fold"], 10.0, -85.0, 85.0);
  leaf.widest = numbers.number_or(json["widest"], 0.4, 0.05, 0.95);
  return leaf;
}

Solid read_cushion(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"size", "softness"});
  return Cushion{numbers.size3(json["size"]), numbers.number_or(json["softness"], 0.4, 0.1, 1.0)};
}

Solid read_picture(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"size", "thickness", "theme", "drawing", "seed"});
  PicturePart picture;
  picture.size = numbers.size2(json["size"]);
  picture.thickness = numbers.number_or(json["thickness"], 0.02, least_length, greatest_length);
  picture.seed = static_cast<std::uint64_t>(numbers.whole_or(json["seed"], 0, 0, max_picture_seed));
  if (json["drawing"].exists()) {
    if (json["theme"].exists()) json.report("expected one of \"theme\" and \"drawing\"");
    picture.theme.clear();
    (void)read_drawing(json["drawing"], numbers, picture.seed);
    if (!numbers.failed()) picture.drawing = concrete_drawing(json["drawing"], numbers);
    return picture;
  }
  picture.theme = numbers.word(json["theme"], picture.theme);
  const std::vector<std::string> themes = picture_themes();
  if (std::find(themes.begin(), themes.end(), picture.theme) == themes.end())
    json["theme"].report("no theme \"" + picture.theme + "\"; there are " + join(themes, ", ") +
                         "; things are drawn: \"drawing\"");
  return picture;
}

constexpr std::array<std::pair<std::string_view, Align>, 3> aligns = {
    {{"left", Align::left}, {"center", Align::center}, {"right", Align::right}}};

Solid read_text(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"words", "align", "height", "fit", "radius", "width", "depth"});
  TextPart text;
  text.words = read_words(json["words"], numbers);
  const Align align = read_align(json["align"], numbers);
  text.align = aligns[static_cast<std::size_t>(align)].first;
  text.height = numbers.length(json["height"]);
  if (json["fit"].exists()) text.fit = numbers.vec2(json["fit"], 0.0, greatest_length);
  text.radius = numbers.length_or_zero(json["radius"], 0.0);
  text.width = numbers.number_or(json["width"], 0.16 * text.height, least_length, greatest_length);
  text.depth = numbers.number_or(json["depth"], 0.01, least_length, greatest_length);
  return text;
}

struct Entry {
  std::string_view key;
  Solid (*read)(const JsonReader&, const Numbers&);
};
constexpr std::array<Entry, 15> entries = {{{"box", read_box},
                                            {"cylinder", read_cylinder},
                                            {"frustum", read_frustum},
                                            {"ellipsoid", read_ellipsoid},
                                            {"prism", read_prism},
                                            {"plane", read_plane},
                                            {"lathe", read_lathe},
                                            {"sweep", read_sweep},
                                            {"extrude", read_extrude},
                                            {"loft", read_loft},
                                            {"height_field", read_height_field},
                                            {"leaf", read_leaf},
                                            {"cushion", read_cushion},
                                            {"picture", read_picture},
                                            {"text", read_text}}};

// Writing.

template <typename Point>
void write_curve(Json& json, const Curve<Point>& curve, const std::string& points_key,
                 const std::string& corners_key) {
  json[points_key] = Json::array();
  for (const auto& point : curve.points) json[points_key].push_back(to_json(point));
  if (curve.corners.empty()) return;
  bool all = curve.corners.size() == curve.points.size();
  for (std::size_t i = 0; all && i < curve.corners.size(); ++i) all = curve.corners[i] == i;
  if (all)
    json[corners_key] = "all";
  else
    json[corners_key] = curve.corners;
}

void write_unless(Json& json, const char* key, double value, double fallback) {
  if (metres(value) != metres(fallback)) json[key] = metres(value);
}

using Written = std::pair<std::string, Json>;

struct SolidWriter {
  Written operator()(const Box& box) const {
    Json json = {{"size", to_json(box.size)}};
    write_unless(json, "bevel", box.bevel, 0.0);
    return {"box", json};
  }
  Written operator()(const Frustum& frustum) const {
    const bool cylinder = metres(frustum.bottom_radius) == metres(frustum.top_radius);
    Json json;
    if (cylinder) {
      json["radius"] = metres(frustum.bottom_radius);
    } else {
      json["bottom_radius"] = metres(frustum.bottom_radius);
      json["top_radius"] = metres(frustum.top_radius);
    }
    json["height"] = metres(frustum.height);
    write_unless(json, "bevel", frustum.bevel, 0.0);
    return {cylinder ? "cylinder" : "frustum", json};
  }
  Written operator()(const Ellipsoid& ellipsoid) const {
    return {"ellipsoid", {{"size", to_json(ellipsoid.size)}}};
  }
  Written operator()(const Prism& prism) const {
    Json json = {{"sides", prism.sides}};
    if (metres(prism.bottom_radius) == metres(prism.top_radius)) {
      json["radius"] = metres(prism.bottom_radius);
    } else {
      json["bottom_radius"] = metres(prism.bottom_radius);
      json["top_radius"] = metres(prism.top_radius);
    }
    json["height"] = metres(prism.height);
    return {"prism", json};
  }
  Written operator()(const Plane& plane) const {
    return {"plane", {{"size", to_json(plane.size)}, {"thickness", metres(plane.thickness)}}};
  }
  Written operator()(const Lathe& lathe) const {
    Json json;
    write_curve(json, lathe.profile, "profile", "corners");
    if (lathe.profile.closed) json["closed"] = true;
    if (file_degrees(lathe.angle) != 360.0) json["angle"] = file_degrees(lathe.angle);
    return {"lathe", json};
  }
  Written operator()(const SweptPart& sweep) const {
    Json json;
    write_curve(json, sweep.path, "path", "corners");
    if (sweep.path.closed) json["closed"] = true;
    if (const auto* disc = std::get_if<Disc>(&sweep.section)) {
      json["radius"] = metres(disc->radius);
    } else if (const auto* rectangle = std::get_if<Rectangle>(&sweep.section)) {
      json["section"] = to_json(rectangle->size);
      write_unless(json, "bevel", rectangle->bevel, 0.0);
    } else {
      write_curve(json, std::get<Curve<Vec2>>(sweep.section), "outline", "outline_corners");
    }
    write_unless(json, "taper", sweep.taper, 1.0);
    if (file_degrees(sweep.twist) != 0.0) json["twist"] = file_degrees(sweep.twist);
    return {"sweep", json};
  }
  Written operator()(const Extrusion& extrusion) const {
    Json json;
    write_curve(json, extrusion.outline, "outline", "corners");
    for (const auto& hole : extrusion.holes) {
      Json written;
      write_curve(written, hole, "outline", "corners");
      json["holes"].push_back(std::move(written));
    }
    json["height"] = metres(extrusion.height);
    write_unless(json, "bevel", extrusion.bevel, 0.0);
    return {"extrude", json};
  }
  Written operator()(const LoftedPart& loft) const {
    Json json = {{"levels", Json::array()}};
    for (const auto& level : loft.levels) {
      Json written = {{"z", metres(level.z)}};
      if (const auto* rounded_size = std::get_if<RoundedSize>(&level.outline)) {
        written["size"] = to_json(rounded_size->size);
        write_unless(written, "round", rounded_size->round, 0.0);
      } else {
        write_curve(written, std::get<Curve<Vec2>>(level.outline), "outline", "corners");
      }
      json["levels"].push_back(std::move(written));
    }
    if (loft.straight) json["straight"] = true;
    return {"loft", json};
  }
  Written operator()(const HeightPart& field) const {
    Json json = {
        {"size", to_json(field.size)}, {"height", field.height}, {"divisions", field.divisions}};
    write_unless(json, "least", field.least, 0.002);
    write_unless(json, "most", field.most, 5.0);
    return {"height_field", json};
  }
  Written operator()(const Leaf& leaf) const {
    return {"leaf",
            {{"length", metres(leaf.length)},
             {"width", metres(leaf.width)},
             {"thickness", metres(leaf.thickness)},
             {"bend", file_degrees(leaf.bend)},
             {"fold", file_degrees(leaf.fold)},
             {"widest", metres(leaf.widest)}}};
  }
  Written operator()(const Cushion& cushion) const {
    return {"cushion", {{"size", to_json(cushion.size)}, {"softness", metres(cushion.softness)}}};
  }
  Written operator()(const PicturePart& picture) const {
    Json json = {{"size", to_json(picture.size)},
                 {"thickness", metres(picture.thickness)},
                 {"seed", picture.seed}};
    if (picture.drawing.empty()) json["theme"] = picture.theme;
    else json["drawing"] = json_literal(picture.drawing);
    return {"picture", json};
  }
  Written operator()(const TextPart& text) const {
    Json json = {{"words", text.words}, {"height", metres(text.height)}};
    if (!text.fit.isZero()) json["fit"] = to_json(text.fit);
    if (text.align != "center") json["align"] = text.align;
    if (text.radius > 0.0) {
      json["radius"] = metres(text.radius);
    } else {
      json["width"] = metres(text.width);
      json["depth"] = metres(text.depth);
    }
    return {"text", json};
  }
  Written operator()(const Group&) const { return {"group", Json::object()}; }
};

}  // namespace

std::vector<std::string> solid_keys() {
  std::vector<std::string> keys;
  for (const auto& entry : entries) keys.emplace_back(entry.key);
  return keys;
}

Solid read_solid(std::string_view key, const JsonReader& json, const Numbers& numbers) {
  const auto entry =
      std::find_if(entries.begin(), entries.end(), [key](const Entry& e) { return e.key == key; });
  return entry->read(json, numbers);
}

Align read_align(const JsonReader& json, const Numbers& numbers) {
  const std::string word = numbers.word(json, "center");
  for (const auto& [name, align] : aligns)
    if (name == word) return align;
  json.report("expected left, center or right");
  return Align::center;
}

std::string read_words(const JsonReader& json, const Numbers& numbers) {
  const std::string words = numbers.word(json, "");
  if (words.size() > most_letters)
    json.report("more than " + std::to_string(most_letters) + " letters");
  else if (lettering(words, Align::left, 1.0).lines.empty())
    json.report("no letter in these words; there are A to Z, 0 to 9 and common marks");
  return words;
}

std::pair<std::string, Json> write_solid(const Solid& solid) {
  return std::visit(SolidWriter{}, solid);
}

double metres(double value) {
  return roomgen::rounded(value, 6);
}
double file_degrees(double angle) {
  return roomgen::rounded(degrees(angle), 6);
}
Json to_json(const Vec2& v) {
  return {metres(v.x()), metres(v.y())};
}
Json to_json(const Vec3& v) {
  return {metres(v.x()), metres(v.y()), metres(v.z())};
}

}  // namespace roomgen::shape::detail
