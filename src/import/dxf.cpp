#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/numbers.h"
#include "drawing.h"
#include "roomgen/base/text.h"
#include "roomgen/import/import.h"

namespace roomgen {

namespace {

using namespace detail;

constexpr const char* dxf_units_hint =
    "Set $INSUNITS in the header to the unit of the drawing (4: mm, 5: cm, 6: m, 1: inches, 2: "
    "feet); without it numbers are metres";

// $INSUNITS (DXF Reference, HEADER section).
constexpr std::array<std::pair<int, double>, 7> insertion_units = {{{0, 1.0},
                                                                    {1, 0.0254},
                                                                    {2, 0.3048},
                                                                    {4, 0.001},
                                                                    {5, 0.01},
                                                                    {6, 1.0},
                                                                    {14, 0.1}}};

/// A group: its code, its value, and the line of the code.
struct Group {
  int code = 0;
  std::string_view value;
  std::size_t line = 0;
};

Result<std::vector<Group>> read_groups(std::string_view text, const std::string& source) {
  std::vector<Group> groups;
  std::size_t line = 0;
  const auto next_line = [&]() {
    const std::size_t end = text.find('\n');
    const std::string_view result = trim(text.substr(0, end));
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    ++line;
    return result;
  };
  while (!text.empty()) {
    std::string_view code = next_line();
    if (code.empty() && text.empty()) break;  // an empty line at the end
    const std::size_t at = line;
    const auto number = take_number(code);
    if (!number || !code.empty() || *number != std::floor(*number) || std::abs(*number) > 2000)
      return located(source, at, "expected the number of a group; is this an ASCII DXF?");
    if (text.empty()) return located(source, at, "the file ends within a group");
    groups.push_back({static_cast<int>(*number), next_line(), at});
  }
  return groups;
}

/// An entity: its groups follow its name.
class DxfReader {
 public:
  DxfReader(std::vector<Group> groups, const std::string& source)
      : groups_(std::move(groups)), source_(source) {}

  Result<Room> run() {
    bool entities = false;
    while (at_ < groups_.size() && !error_) {
      const Group& group = groups_[at_];
      if (group.code == 9 && group.value == "$INSUNITS") {
        ++at_;
        read_units();
      } else if (group.code == 0 && group.value == "SECTION" && at_ + 1 < groups_.size()) {
        entities = groups_[at_ + 1].value == "ENTITIES";
        at_ += 2;
      } else if (group.code == 0 && group.value == "ENDSEC") {
        entities = false;
        ++at_;
      } else if (group.code == 0 && entities) {
        read_entity();
      } else {
        ++at_;
      }
    }
    if (error_) return *error_;
    for (auto& line : lines_)
      for (auto& corner : line.points) corner.point *= unit_;
    return room_from_lines(std::move(lines_), source_, dxf_units_hint);
  }

 private:
  void fail(std::size_t line, const std::string& what) {
    if (!error_) error_ = located(source_, line, what);
  }

  double number(const Group& group) {
    std::string_view rest = group.value;
    const auto value = take_number(rest);
    if (!value || !trim(rest).empty() || std::abs(*value) > 1e12) {
      fail(group.line + 1, "\"" + shortened(std::string(group.value), 30) + "\" is no coordinate");
      return 0.0;
    }
    return *value;
  }

  int integer(const Group& group) {
    const double value = number(group);
    return std::abs(value) < 1e6 ? static_cast<int>(value) : 0;
  }

  void read_units() {
    if (at_ >= groups_.size() || groups_[at_].code != 70) return;
    const Group& group = groups_[at_++];
    const int code = integer(group);
    for (const auto& [known, metres] : insertion_units)
      if (known == code) {
        unit_ = metres;
        return;
      }
    fail(group.line, "$INSUNITS " + std::to_string(code) +
                         " is no unit of rooms; use 4 (mm), 5 (cm), 6 (m), 1 (inches) or 2 (feet)");
  }

  // All groups up to the next entity.
  std::vector<Group> take_body() {
    std::vector<Group> body;
    for (++at_; at_ < groups_.size() && groups_[at_].code != 0; ++at_) body.push_back(groups_[at_]);
    return body;
  }

  void read_entity() {
    const Group head = groups_[at_];
    const auto body = take_body();
    DrawnLine line;
    for (const auto& group : body)
      if (group.code == 8) line.name = shortened(std::string(group.value), 60);
    line.role = role_of(line.name);
    if (head.value == "LWPOLYLINE") read_light_polyline(body, line);
    else if (head.value == "POLYLINE") read_polyline(body, line);
    else if (head.value == "LINE") read_line(body, line);
    else if (head.value == "ARC" || head.value == "CIRCLE") read_arc(body, head, line);
    if (line.points.empty()) return;
    lines_.push_back(std::move(line));
    if (lines_.size() > max_drawn_lines) fail(head.line, "the drawing has too many lines");
  }

  struct Vertex {
    Vec2 point = Vec2::Zero();
    double bulge = 0.0;
    std::size_t line = 0;
  };

  static bool is_closed(int flags) { return (flags & 1) != 0; }

  void read_light_polyline(const std::vector<Group>& body, DrawnLine& line) {
    std::vector<Vertex> vertices;
    for (const auto& group : body) {
      if (group.code == 70) line.closed = is_closed(integer(group));
      if (group.code == 10) vertices.push_back({{number(group), 0.0}, 0.0, group.line});
      if (vertices.empty()) continue;
      if (group.code == 20) vertices.back().point.y() = number(group);
      if (group.code == 42) vertices.back().bulge = number(group);
    }
    draw(vertices, line);
  }

  void read_polyline(const std::vector<Group>& body, DrawnLine& line) {
    for (const auto& group : body)
      if (group.code == 70) line.closed = is_closed(integer(group));
    std::vector<Vertex> vertices;
    while (at_ < groups_.size() && groups_[at_].code == 0 && groups_[at_].value == "VERTEX") {
      Vertex vertex;
      vertex.line = groups_[at_].line;
      for (const auto& group : take_body()) {
        if (group.code == 10) vertex.point.x() = number(group);
        if (group.code == 20) vertex.point.y() = number(group);
        if (group.code == 42) vertex.bulge = number(group);
      }
      vertices.push_back(vertex);
    }
    draw(vertices, line);
  }

  void draw(const std::vector<Vertex>& vertices, DrawnLine& line) {
    if (vertices.empty()) return;
    if (vertices.size() > 10 * max_drawn_corners)
      return fail(vertices.front().line, "a line has too many corners");
    line.points.push_back({vertices.front().point, vertices.front().line});
    for (std::size_t i = 1; i < vertices.size(); ++i)
      append_arc(line.points, vertices[i].point, vertices[i - 1].bulge, vertices[i].line);
    if (line.closed && vertices.back().bulge != 0.0) {
      append_arc(line.points, vertices.front().point, vertices.back().bulge, vertices.back().line);
      line.points.pop_back();
    }
  }

  void read_line(const std::vector<Group>& body, DrawnLine& line) {
    DrawnPoint a, b;
    for (const auto& group : body) {
      if (group.code == 10) a = {{number(group), a.point.y()}, group.line};
      if (group.code == 20) a.point.y() = number(group);
      if (group.code == 11) b = {{number(group), b.point.y()}, group.line};
      if (group.code == 21) b.point.y() = number(group);
    }
    line.points = {a, b};
  }

  // Counter-clockwise from the first angle to the second.
  void read_arc(const std::vector<Group>& body, const Group& head, DrawnLine& line) {
    Vec2 center = Vec2::Zero();
    double radius = 0.0, first = 0.0, last = 0.0;
    for (const auto& group : body) {
      if (group.code == 10) center.x() = number(group);
      if (group.code == 20) center.y() = number(group);
      if (group.code == 40) radius = number(group);
      if (group.code == 50) first = radians(number(group));
      if (group.code == 51) last = radians(number(group));
    }
    // The swing of a door is drawn as an arc; it is no opening of its own.
    if (radius <= 0.0 || (line.role != DrawnRole::outline && line.role != DrawnRole::other)) return;
    const bool whole = head.value == "CIRCLE";
    double angle = whole ? 2.0 * pi : std::remainder(last - first, 2.0 * pi);
    if (angle <= 0) angle += 2.0 * pi;
    const int steps =
        whole ? circle_corners : std::max(1, static_cast<int>(std::ceil(angle / arc_step)));
    for (int i = 0; i <= steps - (whole ? 1 : 0); ++i)
      line.points.push_back({center + rotated(Vec2(radius, 0), first + angle * i / steps), head.line});
    line.closed = whole;
  }

  std::vector<Group> groups_;
  const std::string& source_;
  std::size_t at_ = 0;
  double unit_ = 1.0;
  std::vector<DrawnLine> lines_;
  std::optional<Error> error_;
};

}  // namespace

Result<Room> room_from_dxf(std::string_view text, const std::string& source) {
  if (text.starts_with("AutoCAD Binary DXF"))
    return Error{Error::Kind::invalid_input,
                 source + ": is a binary DXF; save it as ASCII DXF"};
  auto groups = read_groups(text, source);
  if (!groups) return groups.error();
  return DxfReader(*std::move(groups), source).run();
}

}  // namespace roomgen
