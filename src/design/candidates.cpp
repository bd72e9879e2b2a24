#include "candidates.h"

#include <algorithm>
#include <cmath>

namespace roomgen::design {

namespace {

constexpr double wall_pitch = 0.1;
constexpr double floor_pitch = 0.2;
// Between things that only stand together.
constexpr double usual_gaps[] = {0.02, 0.3, 0.7, 1.2};
constexpr double seat_gap = 0.05;
// Width that one seat takes at a table (NKBA: 0.61).
constexpr double seat_width = 0.61;
constexpr double seat_merit = 2.0;
constexpr double over_merit = 2.0;

bool has(const std::vector<Relation>& relations, RelationKind kind) {
  return std::any_of(relations.begin(), relations.end(),
                     [&](const Relation& relation) { return relation.kind == kind; });
}

void along_wall(const Sketch& sketch, const Object& self, std::size_t k, std::vector<Pose>& poses) {
  const Segment line = sketch.room().polygon.edge(k);
  const Vec2 inward = sketch.room().polygon.inward(k);
  const double half = 0.5 * self.size.x(), free = line.length() - self.size.x();
  if (free < 0) return;
  const double yaw = yaw_facing(inward);
  const auto add = [&](double at) {
    if (at < half - 1e-9 || at > line.length() - half + 1e-9) return;
    poses.push_back({line.a + at * line.direction() + 0.5 * self.size.y() * inward, yaw});
  };
  const int steps = static_cast<int>(free / wall_pitch);
  for (int i = 0; i <= steps; ++i) add(half + i * wall_pitch);
  add(line.length() - half);
  add(0.5 * line.length());
  // Flush to and in line with what stands there.
  for (const auto& one : sketch.standing()) {
    const double at = (one.footprint.center() - line.a).dot(line.direction());
    const double reach = std::max(one.footprint.half().x(), one.footprint.half().y());
    for (double other : {one.footprint.half().x(), one.footprint.half().y()}) {
      add(at + other + half + 0.01);
      add(at - other - half - 0.01);
    }
    if (reach > 0) add(at);
  }
}

std::vector<double> gaps(const Sketch& sketch, const Object& self, const Target& target) {
  if (target.object) {
    const auto& own = sketch.categories().get(self.category).gaps;
    const auto& theirs = sketch.categories().get(target.object->category).gaps;
    for (const auto& gap : own)
      if (sketch.categories().is_a(target.object->category, gap.partner))
        return {gap.low + 0.01, 0.5 * (gap.low + gap.high), gap.high};
    for (const auto& gap : theirs)
      if (sketch.categories().is_a(self.category, gap.partner))
        return {gap.low + 0.01, 0.5 * (gap.low + gap.high), gap.high};
  }
  return {std::begin(usual_gaps), std::end(usual_gaps)};
}

// At one side of the target, turned in every sensible direction.
void beside(const Sketch& sketch, const Object& self, const Target& target, Side side,
            std::vector<Pose>& poses) {
  const Footprint& fp = target.footprint;
  const bool across = side == Side::left || side == Side::right;
  const Vec2 outward =
      across ? Vec2(side == Side::left ? 1 : -1, 0) : Vec2(0, side == Side::back ? 1 : -1);
  const Vec2 along = left_of(outward);
  const double reach = across ? fp.half().x() : fp.half().y();
  const double span = across ? fp.half().y() : fp.half().x();
  for (int turn = 0; turn < 4; ++turn) {
    const bool turned = (turn % 2 == 1) != across;
    const double own_reach = 0.5 * (turned ? self.size.x() : self.size.y());
    for (double gap : gaps(sketch, self, target))
      for (double shift : {0.0, -1.0, -0.7, -0.35, 0.35, 0.7, 1.0}) {
        const Vec2 local = (reach + gap + own_reach) * outward + shift * span * along;
        poses.push_back({fp.to_world(local), wrap_angle(fp.yaw() + turn * 0.5 * pi)});
      }
  }
}

// Facing a target from all around, at a comfortable distance.
void ring(const Sketch& sketch, const Object& self, const Target& target,
          std::vector<Pose>& poses) {
  const double reach = target.footprint.half().norm() + 0.5 * self.size.y();
  for (double gap : gaps(sketch, self, target))
    for (int i = 0; i < 24; ++i) {
      const Vec2 outward = rotated({1, 0}, target.footprint.yaw() + i * pi / 12.0);
      poses.push_back({target.footprint.center() + (reach + gap) * outward, yaw_facing(-outward)});
    }
}

// The places of `count` seats at a rectangular table: pairs face each other over the long sides,
// from the fifth on people sit at the ends too. In the table's frame, by side.
std::vector<std::pair<Side, int>> seats_by_side(const Vec2& half, int count) {
  const bool wide = half.x() >= half.y();
  const Side a = wide ? Side::front : Side::left, b = wide ? Side::back : Side::right;
  const Side c = wide ? Side::left : Side::front, d = wide ? Side::right : Side::back;
  const double length = 2.0 * std::max(half.x(), half.y());
  const int most = std::max(1, static_cast<int>(length / seat_width));
  const bool ends = count > 4 || (count > 2 && most < 2);
  const int at_sides = ends ? count - 2 : count;
  return {{a, (at_sides + 1) / 2}, {b, at_sides / 2}, {c, ends ? 1 : 0}, {d, ends ? 1 : 0}};
}

void seats_at_side(const Object& self, const Footprint& fp, Side side, int count, double merit,
                   std::vector<Pose>& poses) {
  const bool across = side == Side::left || side == Side::right;
  const double length = 2.0 * (across ? fp.half().y() : fp.half().x());
  const double reach = (across ? fp.half().x() : fp.half().y()) + seat_gap + 0.5 * self.size.y();
  const double sign = side == Side::left || side == Side::back ? 1.0 : -1.0;
  for (int i = 0; i < count; ++i) {
    const double along = ((i + 0.5) / count - 0.5) * length;
    const Vec2 local = across ? Vec2(sign * reach, along) : Vec2(along, sign * reach);
    const Vec2 outward = across ? Vec2(sign, 0) : Vec2(0, sign);
    poses.push_back({fp.to_world(local), yaw_facing(-rotated(outward, fp.yaw())), merit});
  }
}

// Places at a table for as many as will sit there, then any others.
void seats(const Object& self, const Target& table, int count, std::vector<Pose>& poses) {
  const Footprint& fp = table.footprint;
  if (fp.round()) {
    const double reach = fp.half().x() + seat_gap + 0.5 * self.size.y();
    const int places = std::clamp(count, 2, 12);
    for (int i = 0; i < 2 * places; ++i) {
      const Vec2 outward = rotated({1, 0}, fp.yaw() + i * pi / places);
      poses.push_back(
          {fp.center() + reach * outward, yaw_facing(-outward), i % 2 ? 0.0 : seat_merit});
    }
    return;
  }
  for (const auto& [side, number] : seats_by_side(fp.half(), std::min(count, 40)))
    seats_at_side(self, fp, side, number, seat_merit, poses);
  for (Side side : {Side::front, Side::back, Side::left, Side::right})
    for (int number = 1; number <= 2; ++number) seats_at_side(self, fp, side, number, 0.0, poses);
}

// A rug under its group, or a thing above another.
void over(const Sketch& sketch, const Arrangement& arrangement, const Target& target,
          std::vector<Pose>& poses) {
  const Footprint& fp = target.footprint;
  double forward = 0.0;
  if (target.object)
    for (const auto& [kind, before_front] : arrangement.over)
      if (sketch.categories().is_a(target.object->category, kind))
        forward = fp.half().y() + before_front;
  for (double more : {0.0, 0.2, 0.4, -0.2, -0.4})
    for (int turn = 0; turn < 4; ++turn)
      poses.push_back({fp.to_world({0, -forward - more}), wrap_angle(fp.yaw() + turn * 0.5 * pi),
                       more == 0.0 ? (turn == 0 ? over_merit : 0.5 * over_merit) : 0.0});
}

void all_over(const Sketch& sketch, const Object& self, std::vector<Pose>& poses) {
  const Polygon& polygon = sketch.room().polygon;
  const Bounds2 box = bounds(polygon);
  const double half = 0.5 * std::min(self.size.x(), self.size.y());
  const double pitch = std::max(floor_pitch, std::sqrt(area(polygon)) / 30.0);
  const Vec2 middle = 0.5 * (box.low + box.high);
  // Without a front two directions look alike, and a round thing looks the same from everywhere.
  const std::size_t most = self.traits.front ? 8 : self.traits.round ? 1 : 2;
  std::vector<double> yaws;
  for (std::size_t k = 0; k < polygon.size() && yaws.size() < most; ++k)
    yaws.push_back(yaw_facing(polygon.inward(k)));
  const auto steps = (0.5 * box.size() / pitch).array().floor().cast<int>().eval();
  for (int i = -steps.x(); i <= steps.x(); ++i)
    for (int j = -steps.y(); j <= steps.y(); ++j) {
      const Vec2 point = middle + pitch * Vec2(i, j);
      if (distance_to_boundary(polygon, point) < half || !contains(polygon, point)) continue;
      for (double yaw : yaws) poses.push_back({point, yaw});
    }
}

// Things on a rug.
void all_over(const Footprint& rug, std::vector<Pose>& poses) {
  for (double x : {-0.6, -0.3, 0.0, 0.3, 0.6})
    for (double y : {-0.6, -0.3, 0.0, 0.3, 0.6})
      for (int turn = 0; turn < 4; ++turn)
        poses.push_back({rug.to_world(Vec2(x, y).cwiseProduct(rug.half())),
                         wrap_angle(rug.yaw() + turn * 0.5 * pi)});
}

// Small things flush into the corners and along walls whichever way they look.
void at_walls(const Sketch& sketch, const Object& self, std::vector<Pose>& poses) {
  for (std::size_t k = 0; k < sketch.room().polygon.size(); ++k) along_wall(sketch, self, k, poses);
}

bool wants_side(RelationKind kind, Side side) {
  switch (kind) {
    case RelationKind::in_front_of:
      return side == Side::front;
    case RelationKind::behind:
      return side == Side::back;
    case RelationKind::left_of:
      return side == Side::left;
    case RelationKind::right_of:
      return side == Side::right;
    case RelationKind::side_of:
      return side == Side::left || side == Side::right;
    default:
      return true;
  }
}

void around_target(const Sketch& sketch, const Object& self, const Arrangement& arrangement,
                   const Relation& relation, const std::vector<Relation>& all, int company,
                   std::vector<Pose>& poses) {
  for (const auto& target : sketch.find(relation.target)) {
    const bool lies = self.traits.flat || self.mount != Mount::floor ||
                      relation.kind == RelationKind::on;  // furniture on a rug
    if (lies) over(sketch, arrangement, target, poses);
    if (relation.kind == RelationKind::on) all_over(target.footprint, poses);
    if (lies && target.object) continue;
    if (relation.kind == RelationKind::around) seats(self, target, company, poses);
    if (relation.kind == RelationKind::around && arrangement.seats) continue;
    if (has(all, RelationKind::face_to)) ring(sketch, self, target, poses);
    for (Side side : {Side::front, Side::back, Side::left, Side::right})
      if (wants_side(relation.kind, side)) beside(sketch, self, target, side, poses);
  }
}

}  // namespace

std::vector<Pose> candidates(const Sketch& sketch, const Object& self,
                             const Arrangement& arrangement, const std::vector<Relation>& relations,
                             int company) {
  std::vector<Pose> poses;
  const bool edge = has(relations, RelationKind::edge) || has(relations, RelationKind::corner) ||
                    self.mount == Mount::wall;
  if (edge || !has(relations, RelationKind::middle)) at_walls(sketch, self, poses);
  if (edge) return poses;
  bool targeted = false;
  for (const auto& relation : relations) {
    if (relation.target.empty() || relation.kind == RelationKind::far) continue;
    around_target(sketch, self, arrangement, relation, relations, company, poses);
    targeted = targeted || relation.kind != RelationKind::face_to;
  }
  const bool keeps_to_walls = std::any_of(
      arrangement.likes.begin(), arrangement.likes.end(),
      [](const Like& like) { return like.liking == Liking::wall_near && like.weight >= 1.0; });
  if (!targeted && !keeps_to_walls) all_over(sketch, self, poses);
  return poses;
}

}  // namespace roomgen::design
