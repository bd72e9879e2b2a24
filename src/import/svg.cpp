#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/numbers.h"
#include "drawing.h"
#include "geometry/svg_path.h"
#include "roomgen/base/text.h"
#include "roomgen/import/import.h"
#include "xml.h"

namespace roomgen {

namespace {

using namespace detail;
using Transform = Eigen::Transform<double, 2, Eigen::Affine>;

constexpr int curve_steps = 8;
constexpr std::size_t max_path_points = 20000;
constexpr const char* svg_units_hint =
    "Give the drawing a width with a unit and a viewBox, as in width=\"4200mm\" "
    "viewBox=\"0 0 4200 3600\"; without a unit numbers are metres";

constexpr std::array<std::pair<std::string_view, double>, 5> length_units = {
    {{"mm", 0.001}, {"cm", 0.01}, {"m", 1.0}, {"in", 0.0254}, {"ft", 0.3048}}};

std::string local_name(const std::string& name) {
  const auto colon = name.find(':');
  return lower(colon == std::string::npos ? name : name.substr(colon + 1));
}

class SvgReader {
 public:
  SvgReader(std::vector<XmlElement> elements, const std::string& source)
      : elements_(std::move(elements)), source_(source) {}

  Result<Room> run() {
    if (local_name(elements_[0].name) != "svg")
      return located(source_, elements_[0].line, "is no SVG: its first element is \"" +
                                                     elements_[0].name + "\"");
    const double unit = metres_per_unit();
    for (std::size_t i = 0; i < elements_.size() && !error_; ++i) {
      enter(i);
      if (!groups_.back().is_hidden) draw(elements_[i], unit);
    }
    if (error_) return *error_;
    return room_from_lines(std::move(lines_), source_, svg_units_hint);
  }

 private:
  void fail(const XmlElement& element, const std::string& what) {
    if (!error_) error_ = located(source_, element.line, what);
  }

  // --- Scale ----------------------------------------------------------------------------------

  struct Length {
    double value = 0.0;
    double unit = 0.0;  ///< metres; 0 if it has none
  };

  std::optional<Length> length(const char* attribute) const {
    const std::string* text = elements_[0].find(attribute);
    if (!text) return std::nullopt;
    std::string_view rest = trim(*text);
    const auto value = take_number(rest);
    if (!value || *value <= 0) return std::nullopt;
    for (const auto& [name, unit] : length_units)
      if (lower(trim(rest)) == name) return Length{*value, unit};
    return Length{*value, 0.0};
  }

  // The width and height of the drawing's own units; zero without a viewBox.
  Vec2 view_box() const {
    const std::string* text = elements_[0].find("viewBox");
    if (!text) return Vec2::Zero();
    std::string_view rest = *text;
    std::array<double, 4> v{};
    for (auto& value : v) {
      skip_separators(rest);
      value = take_number(rest).value_or(0.0);
    }
    return {v[2], v[3]};
  }

  double metres_per_unit() {
    const auto width = length("width"), height = length("height");
    const Vec2 box = view_box();
    if (box.minCoeff() <= 0) return width && width->unit > 0 ? width->unit : 1.0;
    // As SVG has it, the smaller scale when both are given.
    double scale = 0.0;
    if (width && width->unit > 0) scale = width->value * width->unit / box.x();
    if (height && height->unit > 0) {
      const double other = height->value * height->unit / box.y();
      scale = scale > 0 ? std::min(scale, other) : other;
    }
    return scale > 0 ? scale : 1.0;
  }

  // --- Elements -------------------------------------------------------------------------------

  /// What an element and the groups around it say together.
  struct Group {
    std::size_t element = XmlElement::none;
    bool is_hidden = false;  ///< in a definition, or not displayed
    std::optional<Transform> place;  ///< once something is drawn in it
    DrawnRole role = DrawnRole::other;  ///< of the nearest that says what it is
    std::string name;                   ///< of that one, or of the nearest that has any
  };

  // Elements come parents first, so those around this one are still there.
  void enter(std::size_t i) {
    const XmlElement& element = elements_[i];
    while (!groups_.empty() && groups_.back().element != element.parent) groups_.pop_back();
    Group group = groups_.empty() ? Group() : groups_.back();
    group.element = i;
    group.is_hidden = group.is_hidden || hides(element);
    group.place.reset();
    name_group(element, i == 0, group);
    groups_.push_back(std::move(group));
  }

  static bool hides(const XmlElement& element) {
    static constexpr std::array<std::string_view, 6> definitions = {
        "defs", "symbol", "clippath", "mask", "pattern", "marker"};
    const std::string* display = element.find("display");
    const std::string* style = element.find("style");
    return std::find(definitions.begin(), definitions.end(), local_name(element.name)) != definitions.end() ||
           (display && *display == "none") || (style && style->find("display:none") != std::string::npos);
  }

  // The drawing itself may have a name, but is no wall.
  static void name_group(const XmlElement& element, bool is_drawing, Group& group) {
    bool is_named = false;
    for (const char* key : {"id", "inkscape:label", "class"}) {
      const std::string* value = element.find(key);
      if (!value || value->empty()) continue;
      const DrawnRole role = is_drawing ? DrawnRole::other : role_of(*value);
      if (role == DrawnRole::other && (is_named || group.role != DrawnRole::other)) continue;
      is_named = true;
      group.name = shortened(*value, 60);
      group.role = role;
      if (role != DrawnRole::other) return;
    }
  }

  double number(const XmlElement& element, const char* attribute) {
    const std::string* text = element.find(attribute);
    if (!text) return 0.0;
    std::string_view rest = trim(*text);
    const auto value = take_number(rest);
    if (!value) fail(element, std::string("\"") + attribute + "\" is no number");
    return value.value_or(0.0);
  }

  void draw(const XmlElement& element, double unit) {
    auto lines = lines_of(element);
    if (lines.empty() || error_) return;
    const Transform& place = place_here();
    for (auto& line : lines) {
      line.name = groups_.back().name;
      line.role = groups_.back().role;
      for (auto& corner : line.points) {
        const Vec2 p = unit * (place * corner.point);
        // The page of an SVG counts downwards.
        corner.point = {p.x(), -p.y()};
        if (!p.allFinite() || p.cwiseAbs().maxCoeff() > 1e9)
          return fail(element, "a coordinate is beyond all bounds");
      }
      lines_.push_back(std::move(line));
    }
    if (lines_.size() > max_drawn_lines) fail(element, "the drawing has too many lines");
  }

  std::vector<DrawnLine> lines_of(const XmlElement& element) {
    const std::string name = local_name(element.name);
    if (name == "rect") return rectangle(element);
    if (name == "line") return straight(element);
    if (name == "polygon" || name == "polyline") return corners(element, name == "polygon");
    if (name == "circle" || name == "ellipse") return ellipse(element);
    return name == "path" ? path(element) : std::vector<DrawnLine>();
  }

  std::vector<DrawnLine> straight(const XmlElement& element) {
    DrawnLine line;
    line.points = {{{number(element, "x1"), number(element, "y1")}, element.line},
                   {{number(element, "x2"), number(element, "y2")}, element.line}};
    return {line};
  }

  std::vector<DrawnLine> path(const XmlElement& element) {
    const std::string* data = element.find("d");
    if (!data) return {};
    const auto subpaths = read_svg_path(
        *data,
        {.curve_steps = curve_steps, .arc_step = arc_step, .most_points = max_path_points});
    if (!subpaths) {
      fail(element, subpaths.error().message);
      return {};
    }
    std::vector<DrawnLine> lines;
    for (const auto& subpath : *subpaths) {
      DrawnLine& line = lines.emplace_back();
      line.closed = subpath.closed;
      for (const auto& point : subpath.points) line.points.push_back({point, element.line});
    }
    return lines;
  }

  std::vector<DrawnLine> rectangle(const XmlElement& element) {
    const Vec2 low(number(element, "x"), number(element, "y"));
    const Vec2 size(number(element, "width"), number(element, "height"));
    DrawnLine line;
    for (const Vec2& share : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)})
      line.points.push_back({low + share.cwiseProduct(size), element.line});
    line.closed = true;
    return {line};
  }

  std::vector<DrawnLine> ellipse(const XmlElement& element) {
    const Vec2 center(number(element, "cx"), number(element, "cy"));
    const double r = number(element, "r");
    const Vec2 radii = r > 0 ? Vec2(r, r) : Vec2(number(element, "rx"), number(element, "ry"));
    DrawnLine line;
    for (int k = 0; k < circle_corners; ++k) {
      const double angle = 2.0 * pi * (k + 0.5) / circle_corners;
      line.points.push_back(
          {center + Vec2(std::cos(angle), std::sin(angle)).cwiseProduct(radii), element.line});
    }
    line.closed = true;
    return {line};
  }

  std::vector<DrawnLine> corners(const XmlElement& element, bool closed) {
    const std::string* text = element.find("points");
    if (!text) return {};
    DrawnLine line;
    line.closed = closed;
    std::string_view rest = *text;
    for (skip_separators(rest); !rest.empty(); skip_separators(rest)) {
      const auto x = take_number(rest);
      skip_separators(rest);
      const auto y = take_number(rest);
      if (!x || !y) {
        fail(element, "\"points\" must be pairs of numbers");
        return {};
      }
      line.points.push_back({{*x, *y}, element.line});
    }
    return {line};
  }

  // --- Transforms -----------------------------------------------------------------------------

  // Only where something is drawn: what is not need not be understood.
  const Transform& place_here() {
    Transform around = Transform::Identity();
    for (Group& group : groups_) {
      if (!group.place) {
        const XmlElement& element = elements_[group.element];
        const std::string* text = element.find("transform");
        group.place = text ? around * parse_transform(element, *text) : around;
      }
      around = *group.place;
    }
    return *groups_.back().place;
  }

  Transform parse_transform(const XmlElement& element, std::string_view rest) {
    Transform total = Transform::Identity();
    for (skip_separators(rest); !rest.empty(); skip_separators(rest)) {
      const auto open = rest.find('('), close = rest.find(')');
      if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
        fail(element, "\"transform\" is not understood");
        return total;
      }
      total = total * one_transform(element, trim(rest.substr(0, open)),
                                    rest.substr(open + 1, close - open - 1));
      rest.remove_prefix(close + 1);
    }
    return total;
  }

  Transform one_transform(const XmlElement& element, std::string_view kind,
                          std::string_view arguments) {
    std::vector<double> v;
    for (skip_separators(arguments); !arguments.empty() && v.size() < 7; skip_separators(arguments)) {
      const auto value = take_number(arguments);
      if (!value) break;
      v.push_back(*value);
    }
    Transform t = Transform::Identity();
    if (kind == "translate" && !v.empty())
      t.translate(Vec2(v[0], v.size() > 1 ? v[1] : 0.0));
    else if (kind == "scale" && !v.empty())
      t.scale(Vec2(v[0], v.size() > 1 ? v[1] : v[0]));
    else if (kind == "rotate" && v.size() == 1)
      t.rotate(radians(v[0]));
    else if (kind == "rotate" && v.size() == 3)
      t.translate(Vec2(v[1], v[2])).rotate(radians(v[0])).translate(Vec2(-v[1], -v[2]));
    else if (kind == "matrix" && v.size() == 6)
      t.matrix() << v[0], v[2], v[4], v[1], v[3], v[5], 0, 0, 1;
    else
      fail(element, "\"" + std::string(kind.substr(0, 20)) +
                        "\" is no transform that is read: translate, scale, rotate, matrix");
    return t;
  }

  std::vector<XmlElement> elements_;
  const std::string& source_;
  std::vector<Group> groups_;  ///< around the element that is read, and itself
  std::vector<DrawnLine> lines_;
  std::optional<Error> error_;
};

}  // namespace

Result<Room> room_from_svg(std::string_view text, const std::string& source) {
  auto elements = parse_xml(text, source);
  if (!elements) return elements.error();
  return SvgReader(*std::move(elements), source).run();
}

}  // namespace roomgen
