#include "drawing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "base/random.h"
#include "color.h"
#include "letters.h"
#include "motifs.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/shape/program.h"
#include "solid_json.h"

namespace roomgen::shape {

namespace {

using detail::Numbers;
using Place = Eigen::Affine2d;

constexpr int drawn_side = 512;
constexpr int deepest = 8;                 // groups and motifs in one another
constexpr std::size_t most_shapes = 1024;  // in one list
constexpr std::size_t most_paints = 20'000, most_drawn_points = 400'000;
constexpr int most_copies = 500;
constexpr double farthest = 10.0;  // of coordinates
constexpr double drawn_tolerance = 0.0008;
constexpr double pen_of_letters = 0.16;  // of their height
const Tint paper(244, 239, 230);

// What a shape takes from what is around it.
struct Inherited {
  Place place = Place::Identity();
  std::vector<Tint> colors;  ///< dark to light, in place of the shape's own
  double opacity = 1.0;
  int depth = 0;
};

double lightness(const Tint& color) {
  return color.dot(Tint(0.299, 0.587, 0.114)) / 255.0;
}

// The colour as light as this one among the others, dark to light; of a single one its shades.
Tint recolored(const Tint& color, const std::vector<Tint>& colors) {
  if (colors.empty()) return color;
  const double light = std::clamp(lightness(color), 0.0, 1.0);
  if (colors.size() == 1) {
    const Tint dark = 0.35 * colors[0], bright = mixed(colors[0], {255, 255, 255}, 0.85);
    return light < 0.5 ? mixed(dark, colors[0], 2 * light)
                       : mixed(colors[0], bright, 2 * light - 1);
  }
  const double at = light * static_cast<double>(colors.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(at), colors.size() - 2);
  return mixed(colors[below], colors[below + 1], at - static_cast<double>(below));
}

struct DrawnLine {
  std::vector<Vec2> points;
  bool closed = true;
};

class Sketcher {
 public:
  Sketcher(const Numbers& numbers, std::uint64_t seed) : numbers_(numbers), seed_(seed) {}

  Drawing read(const JsonReader& json) {
    json.allow_only({"ground", "colors", "shapes"});
    Inherited around;
    around.colors = colors(json["colors"]);
    ground_ = recolored(ground(json, !around.colors.empty()), around.colors);
    shapes(json["shapes"], around);
    return {ground_, std::move(paints_)};
  }

 private:
  Vec2 vec2_or(const JsonReader& json, const Vec2& fallback, double low = -farthest) const {
    return json.exists() ? numbers_.vec2(json, low, farthest) : fallback;
  }

  Tint own_color(const JsonReader& json) const {
    const Rgb rgb = detail::read_color(json, numbers_);
    return {static_cast<double>(rgb[0]), static_cast<double>(rgb[1]), static_cast<double>(rgb[2])};
  }

  // One colour, or several: of these the seed takes one, a palette the lightest.
  Tint one_of(const JsonReader& json, bool lightest) const {
    if (!json.is_array()) return own_color(json);
    std::vector<Tint> choices;
    for (const auto& choice : json.elements(64)) choices.push_back(own_color(choice));
    if (choices.empty()) return paper;
    if (!lightest) return Random(seed_).fork("ground").pick(choices);
    return *std::max_element(choices.begin(), choices.end(), [](const Tint& a, const Tint& b) {
      return lightness(a) < lightness(b);
    });
  }

  // Its own, else that of the first motif, else paper.
  Tint ground(const JsonReader& json, bool lightest) const {
    if (json["ground"].exists()) return one_of(json["ground"], lightest);
    for (const auto& shape : json["shapes"].elements(most_shapes)) {
      if (!shape.is_object() || !shape["use"].exists()) continue;
      const Motif* motif = find_motif(numbers_.word(shape["use"], ""));
      if (motif) return one_of(JsonReader(*motif->drawing, own_problems_)["ground"], lightest);
    }
    return paper;
  }

  // A palette's name or a list of colours.
  std::vector<Tint> colors(const JsonReader& json) const {
    std::vector<Tint> result;
    if (json.is_string()) {
      const std::string name = numbers_.word(json, "");
      const auto* known = find_palette(name);
      if (!known && !name.empty()) json.report("no palette \"" + name.substr(0, 60) + "\"");
      for (const auto& text : known ? *known : std::vector<std::string>()) {
        const Rgb rgb = parse_color(text).value_or(Rgb{});
        result.emplace_back(rgb[0], rgb[1], rgb[2]);
      }
      return result;
    }
    for (const auto& element : json.elements_or_none(16)) result.push_back(own_color(element));
    std::stable_sort(result.begin(), result.end(),
                     [](const Tint& a, const Tint& b) { return lightness(a) < lightness(b); });
    return result;
  }

  Tint color(const JsonReader& json, const Inherited& around) const {
    if (json.is_string() && json.text() == "ground") return ground_;
    return recolored(own_color(json), around.colors);
  }

  void shapes(const JsonReader& list, const Inherited& around) {
    if (around.depth > deepest)
      return list.report("more than " + std::to_string(deepest) + " groups in one another");
    for (const auto& shape : list.elements(most_shapes))
      if (!numbers_.failed()) copies(shape, around);
  }

  void copies(const JsonReader& json, const Inherited& outer) {
    if (!numbers_.spend(json, 10)) return;
    json.allow_only({"polygon", "curve",  "circle",  "ellipse", "rectangle", "line",    "text",
                     "use",     "group",  "corners", "round",   "height",    "align",   "fit",
                     "size",    "colors", "fill",    "stroke",  "width",     "opacity", "at",
                     "turn",    "scale",  "mirror",  "repeat",  "scatter",   "when"});
    if (numbers_.failed()) return;
    if (json["when"].exists() && numbers_.number(json["when"], -1e9, 1e9) == 0.0) return;
    Inherited around = outer;
    around.opacity *= numbers_.number_or(json["opacity"], 1.0, 0.0, 1.0);
    if (json["colors"].exists()) around.colors = colors(json["colors"]);
    const Place own = place_of(json);
    std::vector<Place> all = {Place::Identity()};
    if (json["repeat"].exists()) all = repeated(json["repeat"]);
    if (json["scatter"].exists()) all = scattered(json["scatter"], all);
    for (const auto& copy : all) {
      around.place = outer.place * own * copy;
      one(json, around);
      if (!json["mirror"].boolean_or(false)) continue;
      around.place = outer.place * Eigen::Scaling(-1.0, 1.0) * own * copy;
      one(json, around);
    }
  }

  // Scaled, then turned, then moved. A motif's square has its middle there.
  Place place_of(const JsonReader& json) const {
    const bool is_motif = json["use"].exists();
    const Vec2 middle = is_motif || json["text"].exists() ? Vec2(0.5, 0.5) : Vec2(0, 0);
    const JsonReader at = json["at"], scale = json[is_motif ? "size" : "scale"];
    Place place = Place::Identity();
    place.translate(vec2_or(at, middle));
    place.rotate(numbers_.angle_or(json["turn"], 0.0, -3600.0, 3600.0));
    if (scale.is_array())
      place.scale(numbers_.vec2(scale, -farthest, farthest));
    else
      place.scale(numbers_.number_or(scale, 1.0, -farthest, farthest));
    if (is_motif) place.translate(Vec2(-0.5, -0.5));
    return place;
  }

  // Each a step further and turned further about the shape's own origin.
  std::vector<Place> repeated(const JsonReader& json) const {
    json.allow_only({"count", "step", "turn", "scale"});
    const int count = numbers_.whole(json["count"], 1, most_copies);
    const Vec2 step = vec2_or(json["step"], {0, 0});
    const double turn = numbers_.angle_or(json["turn"], 0.0, -3600.0, 3600.0);
    const double scale = numbers_.number_or(json["scale"], 1.0, 0.1, 10.0);
    std::vector<Place> result;
    for (int k = 0; k < count; ++k) {
      Place place = Place::Identity();
      place.translate(k * step);
      place.rotate(k * turn);
      place.scale(std::min(std::pow(scale, k), 1e3));
      result.push_back(place);
    }
    return result;
  }

  std::vector<Place> scattered(const JsonReader& json, const std::vector<Place>& copies) const {
    json.allow_only({"count", "from", "to", "scale", "turn", "seed"});
    const int count = numbers_.whole(json["count"], 1, most_copies);
    const Vec2 from = vec2_or(json["from"], {0, 0});
    const Vec2 to = vec2_or(json["to"], {1, 1});
    const Vec2 scale = vec2_or(json["scale"], {1, 1}, 0.01);
    const double turn = numbers_.angle_or(json["turn"], 0.0, 0.0, 360.0);
    const int own = numbers_.whole_or(json["seed"], 0, 0, 1'000'000);
    Random random(seed_ * 1'000'003u + static_cast<std::uint64_t>(own));
    std::vector<Place> result;
    for (int k = 0; k < count; ++k) {
      Place place = Place::Identity();
      const double x = random.uniform(), y = random.uniform();
      place.translate(Vec2(from + Vec2(x, y).cwiseProduct(to - from)));
      place.rotate(turn * (random.uniform() - 0.5));
      place.scale(scale.x() + random.uniform() * (scale.y() - scale.x()));
      for (const auto& copy : copies) result.push_back(place * copy);
    }
    return result;
  }

  void one(const JsonReader& json, const Inherited& around) {
    if (numbers_.failed()) return;
    if (json["group"].exists()) {
      Inherited inner = around;
      ++inner.depth;
      return shapes(json["group"], inner);
    }
    if (json["use"].exists()) return motif(json, around);
    if (json["text"].exists()) return text(json, around);
    const bool is_line = json["line"].exists();
    const DrawnLine line = is_line ? line_of(json, "line", false) : outline(json);
    if (numbers_.failed()) return;
    const auto fill = json["fill"], stroke = json["stroke"];
    if (!stroke.exists() && (is_line || !fill.exists()))
      return json.report(is_line ? "a line needs \"stroke\", a colour"
                                 : "nothing to paint with: \"fill\" or \"stroke\" is missing");
    if (fill.exists() && !is_line) paint(json, {{line.points}, color(fill, around), 1.0}, around);
    if (stroke.exists())
      pen(json, {line}, color(stroke, around), numbers_.number_or(json["width"], 0.01, 0.0005, 2.0),
          around);
  }

  DrawnLine outline(const JsonReader& json) const {
    if (json["polygon"].exists()) {
      auto curve = detail::read_curve2(json, numbers_, "polygon", "corners", true);
      return {std::move(curve.points), true};
    }
    if (json["curve"].exists()) return line_of(json, "curve", true);
    if (json["circle"].exists()) {
      const double radius = numbers_.number(json["circle"], 0.0005, farthest);
      return {ellipse(Vec2::Constant(2 * radius), drawn_tolerance).points, true};
    }
    if (json["ellipse"].exists())
      return {ellipse(vec2_or(json["ellipse"], {1, 1}, 0.001), drawn_tolerance).points, true};
    if (json["rectangle"].exists()) {
      const Vec2 size = numbers_.vec2(json["rectangle"], 0.001, 2 * farthest);
      const double round = numbers_.number_or(json["round"], 0.0, 0.0, farthest);
      return {polyline(rectangle(size, round, drawn_tolerance), drawn_tolerance), true};
    }
    json.report(
        "no shape; expected one of polygon, curve, circle, ellipse, rectangle, line, text, "
        "use, group");
    return {};
  }

  DrawnLine line_of(const JsonReader& json, const char* key, bool closed) const {
    const auto curve = detail::read_curve2(json, numbers_, key, "corners", closed);
    DrawnLine line{polyline(curve, drawn_tolerance), closed};
    if (line.points.empty() && !numbers_.failed())
      json[key].report("these points make no curve: too few of them differ");
    return line;
  }

  void text(const JsonReader& json, const Inherited& around) {
    const double height = numbers_.number_or(json["height"], 0.1, 0.002, 2.0);
    const auto align = detail::read_align(json["align"], numbers_);
    std::vector<DrawnLine> lines;
    const Vec2 fit = vec2_or(json["fit"], {0, 0}, 0.0);
    const std::string words = detail::read_words(json["text"], numbers_);
    const Lettering letters = lettering(words, align, height, fit);
    for (const auto& curve : letters.lines)
      lines.push_back({polyline(curve, drawn_tolerance), curve.closed});
    if (!json["fill"].exists()) return json.report("text needs \"fill\", its colour");
    const double width = numbers_.number_or(json["width"], pen_of_letters * height, 0.0005, 1.0);
    pen(json, lines, color(json["fill"], around), width * letters.height / height, around);
  }

  void motif(const JsonReader& json, Inherited around) {
    const std::string name = numbers_.word(json["use"], "");
    const Motif* motif = find_motif(name);
    if (!motif) {
      const std::string close = closest_name(name, motif_names());
      return json["use"].report("no motif \"" + name.substr(0, 60) + "\"" +
                                (close.empty() ? "; there are " + join(motif_names(), ", ")
                                               : "; did you mean \"" + close + "\"?"));
    }
    ++around.depth;
    if (motif->turned && Random(seed_).fork(name).chance(0.5))
      around.place = around.place * Eigen::Translation2d(1.0, 0.0) * Eigen::Scaling(-1.0, 1.0);
    shapes(JsonReader(*motif->drawing, own_problems_)["shapes"], around);
  }

  void pen(const JsonReader& json, const std::vector<DrawnLine>& lines, const Tint& color,
           double width, const Inherited& around) {
    const double scale = std::sqrt(std::abs(around.place.linear().determinant()));
    Paint result{{}, color, 1.0};
    for (const auto& line : lines) {
      std::vector<Vec2> points;
      for (const auto& point : line.points) points.push_back(around.place * point);
      if (points.size() < 2) continue;
      auto outlines = pen_outlines(points, line.closed, width * scale);
      std::move(outlines.begin(), outlines.end(), std::back_inserter(result.outlines));
    }
    Inherited placed = around;
    placed.place = Place::Identity();
    paint(json, std::move(result), placed);
  }

  void paint(const JsonReader& json, Paint paint, const Inherited& around) {
    for (auto& outline : paint.outlines) {
      for (auto& point : outline) point = around.place * point;
      points_ += outline.size();
    }
    if (points_ > most_drawn_points || paints_.size() >= most_paints)
      return json.report("a drawing of more than " + std::to_string(most_paints) + " shapes or " +
                         std::to_string(most_drawn_points) + " points, copies counted");
    paint.opacity = around.opacity;
    paints_.push_back(std::move(paint));
  }

  const Numbers& numbers_;
  std::uint64_t seed_;
  Tint ground_ = paper;
  std::vector<Paint> paints_;
  std::size_t points_ = 0;
  mutable JsonReader::Problems own_problems_{"data/motifs.json"};
};

// Keys whose texts are no formulas.
bool is_wordy(std::string_view key) {
  static constexpr std::array<std::string_view, 8> keys = {"ground", "colors",  "fill",  "stroke",
                                                           "text",   "corners", "align", "use"};
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

Json concrete(const JsonReader& json, const Numbers& numbers, std::string_view key) {
  const Json& raw = *json.raw();
  if (raw.is_string() && is_wordy(key)) return numbers.word(json, "");
  if (raw.is_string() || raw.is_number()) return numbers.number(json, -1e9, 1e9);
  if (!raw.is_structured()) return raw;
  Json result = raw.is_array() ? Json::array() : Json::object();
  if (raw.is_array())
    for (const auto& element : json.elements()) result.push_back(concrete(element, numbers, key));
  else
    for (const auto& [name, member] : json.members())
      result[name] = concrete(member, numbers, name);
  return result;
}

}  // namespace

Drawing read_drawing(const JsonReader& json, const Numbers& numbers, std::uint64_t seed) {
  return Sketcher(numbers, seed).read(json);
}

std::string concrete_drawing(const JsonReader& json, const Numbers& numbers) {
  return concrete(json, numbers, "").dump();
}

Image paint_drawing(const std::string& text, std::uint64_t seed, double aspect) {
  const double a = std::clamp(aspect, 0.2, 5.0);
  const auto pixels = [](double part) { return static_cast<int>(std::lround(drawn_side * part)); };
  const int width = pixels(std::min(a, 1.0)), height = pixels(std::min(1.0 / a, 1.0));
  Drawing drawing{{255, 255, 255}, {}};
  if (const auto json = parse_json(text, "drawing")) {
    JsonReader::Problems problems("drawing");
    detail::Reading reading;
    drawing = read_drawing(JsonReader(*json, problems), Numbers(nullptr, reading, problems), seed);
  }
  Canvas canvas(width, height, drawing.ground);
  const double unit = std::min(width, height);
  for (auto& paint : drawing.paints) {
    for (auto& outline : paint.outlines)
      for (auto& point : outline)
        point = 0.5 * Vec2(width, height) + unit * Vec2(point.x() - 0.5, 0.5 - point.y());
    canvas.fill(paint.outlines, paint.color, paint.opacity);
  }
  return canvas.image();
}

}  // namespace roomgen::shape
