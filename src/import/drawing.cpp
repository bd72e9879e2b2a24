#include "drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "roomgen/base/text.h"
#include "roomgen/import/import.h"

namespace roomgen::detail {

namespace {

constexpr double joint = 2e-3;          // metres between the ends of lines that meet
constexpr double least_angle = 0.035;   // radians (2 degrees) between walls at a corner
constexpr double wall_reach = 0.35;     // openings may be drawn anywhere in a thick wall
constexpr double overhang = 0.05;       // and a little beyond its end
constexpr double least_opening = 0.3;

constexpr std::array<std::pair<std::string_view, DrawnRole>, 9> role_names = {{
    {"door", DrawnRole::door},
    {"window", DrawnRole::window},
    {"passage", DrawnRole::passage},
    {"opening", DrawnRole::passage},
    {"archway", DrawnRole::passage},
    {"room", DrawnRole::outline},
    {"outline", DrawnRole::outline},
    {"wall", DrawnRole::outline},
    {"floor", DrawnRole::outline},
}};

std::string text(const Vec2& p) {
  return "(" + format_number(p.x(), 3) + ", " + format_number(p.y(), 3) + ")";
}

bool meet(const Vec2& a, const Vec2& b) {
  return (a - b).norm() <= joint;
}

// Lines of which each begins where the one before ends.
class Chainer {
 public:
  Chainer(std::vector<DrawnLine> lines, const std::string& source)
      : rest_(std::move(lines)), source_(source) {}

  Result<std::vector<DrawnPoint>> run() {
    DrawnLine chain = std::move(rest_.front());
    rest_.erase(rest_.begin());
    while (!is_closed(chain)) {
      const auto next = std::find_if(rest_.begin(), rest_.end(), [&](const DrawnLine& line) {
        return !line.closed && (meet(line.points.front().point, chain.points.back().point) ||
                                meet(line.points.back().point, chain.points.back().point));
      });
      if (next == rest_.end()) return open_at(chain);
      if (!meet(next->points.front().point, chain.points.back().point))
        std::reverse(next->points.begin(), next->points.end());
      chain.points.insert(chain.points.end(), next->points.begin() + 1, next->points.end());
      rest_.erase(next);
    }
    if (!rest_.empty())
      return located(source_, rest_.front().points.front().line,
                     "here begins a second outline; a floor plan has one. Name the outline's layer "
                     "or id \"room\", and those of doors and windows \"door\" and \"window\"");
    if (meet(chain.points.front().point, chain.points.back().point)) chain.points.pop_back();
    return std::move(chain.points);
  }

 private:
  static bool is_closed(const DrawnLine& line) {
    return line.closed || (line.points.size() > 2 &&
                           meet(line.points.front().point, line.points.back().point));
  }

  Error open_at(const DrawnLine& chain) const {
    return located(source_, chain.points.back().line,
                   "the outline is open: it ends at " + text(chain.points.back().point) +
                       " and begins at " + text(chain.points.front().point) +
                       " m; close it, or let its lines end where the next ones begin");
  }

  std::vector<DrawnLine> rest_;
  const std::string& source_;
};

Status check_size(const std::vector<DrawnPoint>& corners, const std::string& source,
                  const std::string& units) {
  Bounds2 box;
  for (const auto& corner : corners) box.add(corner.point);
  const Vec2 size = box.size();
  if (size.minCoeff() >= least_drawn_side && size.maxCoeff() <= greatest_drawn_side) return {};
  return located(source, corners.front().line,
                 "the outline is " + format_number(size.x(), 3) + " x " +
                     format_number(size.y(), 3) + " m; sides of a room are " +
                     format_number(least_drawn_side) + " to " +
                     format_number(greatest_drawn_side) + " m. " + units);
}

void drop_repeated(std::vector<DrawnPoint>& corners) {
  std::vector<DrawnPoint> kept;
  for (const auto& corner : corners)
    if (kept.empty() || !meet(kept.back().point, corner.point)) kept.push_back(corner);
  while (kept.size() > 1 && meet(kept.back().point, kept.front().point)) kept.pop_back();
  corners = std::move(kept);
}

Status check_spikes(const std::vector<DrawnPoint>& corners, const std::string& source) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 back = corners[(i + n - 1) % n].point - corners[i].point;
    const Vec2 on = corners[(i + 1) % n].point - corners[i].point;
    const double angle = std::abs(std::atan2(cross(back, on), back.dot(on)));
    if (angle < least_angle)
      return located(source, corners[i].line,
                     "the outline has a spike at " + text(corners[i].point) +
                         " m: the walls before and behind it run back on each other; leave this "
                         "corner out");
  }
  return {};
}

Result<Polygon> polygon_of(const std::vector<DrawnPoint>& corners, const std::string& source) {
  std::vector<Vec2> points;
  for (const auto& corner : corners) points.push_back(corner.point);
  auto polygon = make_polygon(points);
  if (!polygon) return located(source, corners.front().line, polygon.error().message);
  return polygon;
}

Result<Polygon> outline_of(std::vector<DrawnLine> lines, const std::string& source,
                           const std::string& units) {
  if (lines.empty())
    return Error{Error::Kind::invalid_input,
                 source + ": draws no outline; draw the inner faces of the walls as one closed line"};
  auto corners = Chainer(std::move(lines), source).run();
  if (!corners) return corners.error();
  if (auto status = check_size(*corners, source, units); !status) return status.error();
  drop_repeated(*corners);
  if (corners->size() > max_drawn_corners)
    return located(source, corners->front().line,
                   "the outline has " + std::to_string(corners->size()) + " corners; at most " +
                       std::to_string(max_drawn_corners) + " are read. Draw curves with fewer lines");
  if (auto status = check_spikes(*corners, source); !status) return status.error();
  return polygon_of(*corners, source);
}

OpeningType type_of(DrawnRole role) {
  if (role == DrawnRole::window) return OpeningType::window;
  return role == DrawnRole::door ? OpeningType::door : OpeningType::passage;
}

// The wall along which all of an opening's points lie, the nearest if there are several.
std::optional<std::size_t> wall_along(const Polygon& polygon, const DrawnLine& line) {
  std::optional<std::size_t> best;
  double best_distance = wall_reach;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Segment wall = polygon.edge(k);
    double far = 0.0, low = 1e300, high = -1e300;
    for (const auto& corner : line.points) {
      const double along = (corner.point - wall.a).dot(wall.direction());
      far = std::max(far, std::abs((corner.point - wall.a).dot(polygon.inward(k))));
      low = std::min(low, along);
      high = std::max(high, along);
    }
    if (low < -overhang || high > wall.length() + overhang || high - low < least_opening) continue;
    if (far < best_distance) best = k, best_distance = far;
  }
  return best;
}

Result<Opening> opening_of(const DrawnLine& line, const Room& room, const std::string& source) {
  const auto wall = wall_along(room.polygon, line);
  if (!wall)
    return located(source, line.points.front().line,
                   "\"" + line.name + "\" lies along no wall; draw a door or window as a line of at "
                   "least " + format_number(least_opening) + " m on the outline");
  const Segment edge = room.polygon.edge(*wall);
  double low = 1e300, high = -1e300;
  for (const auto& corner : line.points) {
    const double along = (corner.point - edge.a).dot(edge.direction());
    low = std::min(low, along);
    high = std::max(high, along);
  }
  Opening opening;
  opening.type = type_of(line.role);
  opening.wall = *wall;
  opening.from = std::max(0.0, low);
  opening.to = std::min(edge.length(), high);
  if (opening.type == OpeningType::window) {
    opening.sill = default_sill;
    opening.head = default_window_head;
  }
  // The leaf opens against the nearer wall.
  opening.hinge_at_from = opening.from <= edge.length() - opening.to;
  return opening;
}

Status add_openings(const std::vector<DrawnLine>& lines, const std::string& source, Room& room) {
  std::size_t doors = 0, windows = 0, passages = 0;
  for (const auto& line : lines) {
    auto opening = opening_of(line, room, source);
    if (!opening) return opening.error();
    std::size_t& number = opening->type == OpeningType::door     ? doors
                          : opening->type == OpeningType::window ? windows
                                                                 : passages;
    opening->id = std::string(name(opening->type)) + "-" + std::to_string(number++);
    room.openings.push_back(*std::move(opening));
    if (auto status = check(room); !status)
      return located(source, line.points.front().line, status.error().message);
  }
  return {};
}

void move_to_origin(std::vector<DrawnLine>& lines, const Polygon& polygon) {
  const Vec2 low = bounds(polygon).low;
  for (auto& line : lines)
    for (auto& corner : line.points) corner.point -= low;
}

}  // namespace

DrawnRole role_of(std::string_view name) {
  const std::string text = lower(trim(name));
  for (const auto& [word, role] : role_names)
    if (text.starts_with(word)) return role;
  return DrawnRole::other;
}

Result<Room> room_from_lines(std::vector<DrawnLine> lines, const std::string& source,
                             const std::string& units) {
  std::vector<DrawnLine> outline, other, openings;
  for (auto& line : lines) {
    if (line.points.size() < 2) continue;
    auto& list = line.role == DrawnRole::outline ? outline
                 : line.role == DrawnRole::other ? other
                                                 : openings;
    list.push_back(std::move(line));
  }
  auto polygon = outline_of(outline.empty() ? std::move(other) : std::move(outline), source, units);
  if (!polygon) return polygon.error();
  move_to_origin(openings, *polygon);
  const Vec2 low = bounds(*polygon).low;
  Room room;
  room.polygon = *std::move(polygon);
  for (auto& point : room.polygon.points) point -= low;
  if (auto status = add_openings(openings, source, room); !status) return status.error();
  return room;
}

void append_arc(std::vector<DrawnPoint>& points, const Vec2& end, double bulge, std::size_t line) {
  const Vec2 start = points.back().point;
  const double angle = 4.0 * std::atan(bulge), chord = (end - start).norm();
  if (chord > 0 && std::abs(angle) > 1e-3 && std::abs(angle) < 2.0 * pi - 1e-3) {
    // The centre lies on the chord's bisector; a positive bulge turns left along the arc.
    const double apothem = 0.5 * chord / std::tan(0.5 * angle);
    const Vec2 center = 0.5 * (start + end) + apothem * left_of(Vec2((end - start) / chord));
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / arc_step)));
    for (int i = 1; i < steps; ++i)
      points.push_back({center + rotated(Vec2(start - center), angle * i / steps), line});
  }
  points.push_back({end, line});
}

Error located(const std::string& source, std::size_t line, const std::string& what) {
  return {Error::Kind::invalid_input, source + ":" + std::to_string(line) + ": " + what};
}

}  // namespace roomgen::detail
