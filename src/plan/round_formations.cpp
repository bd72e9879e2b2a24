#include "round_formations.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "formation_site.h"

namespace roomgen::plan {

namespace {

constexpr double gaps_beside[] = {0.6, 0.4, 0.25, 0.12, 0.05};  ///< metres between neighbours, the loosest first
constexpr double usual_gap = 0.25, around_all = 1.2;  ///< metres that a room is chosen for, between and around them
constexpr double feet_in_middle = 1.0;    ///< metres across that stay free within
constexpr double before_round = 0.35, before_corners = 0.15;  ///< metres between what stands in the middle and those around it
constexpr double view = 1.4;              ///< metres between those in an arc and what they face
constexpr double half_turn = pi, arc_at_wall = 140.0 / 180.0 * pi;
constexpr double places_every = 0.25;     ///< metres, where a middle is looked for

/// Where things stand around a point; angles in radians, counter-clockwise from +X.
struct Ring {
  Vec2 center = Vec2::Zero();
  double radius = 0.0, first = 0.0, step = 0.0;

  Vec2 at(std::size_t number) const {
    const double angle = first + step * static_cast<double>(number);
    return center + radius * Vec2(std::cos(angle), std::sin(angle));
  }
};

// So that neighbours' nearest corners, which are those towards the middle, are a gap apart.
double radius_of(const Vec2& size, double step, double gap, double inside) {
  const double to_front = std::max(inside, 0.5 * (size.x() + gap) / std::tan(0.5 * std::min(step, 0.5 * pi)));
  return to_front + 0.5 * size.y();
}

// From the middle of what things stand around to where their fronts may be.
double around(const PlanItem& focus, const KindTable& table) {
  if (!focus.size) return 0.5 * feet_in_middle;
  const Vec2 size = focus.size->head<2>();
  return table.get(focus.category).traits.round ? 0.5 * size.maxCoeff() + before_round : 0.5 * size.norm() + before_corners;
}

double angle_of(const Vec2& direction) { return std::atan2(direction.y(), direction.x()); }

/// Things of one size around a point of a room.
class RoundFormation {
 public:
  RoundFormation(const Draft& draft, std::size_t count, const Draft* focus, const Room& room, const KindTable& table)
      : draft_(draft), count_(count), focus_(focus), room_(room), size_(draft.item.size->head<2>()),
        inside_(focus ? around(focus->item, table) : 0.5 * feet_in_middle) {}

  std::optional<Ring> circle() const {
    const Vec2 center = roomiest();
    const double step = 2.0 * pi / static_cast<double>(count_);
    // Who comes in walks between two of them.
    const double first = angle_of(way_in() - center) + 0.5 * step;
    return loosest([&](double gap) { return Ring{center, radius(step, gap, inside_), first, step}; });
  }

  // Open towards a wall; with what they face at the wall, around that.
  std::optional<Ring> arc(std::size_t wall) const {
    const Vec2 forward = -room_.polygon.inward(wall);
    const double span = focus_ ? arc_at_wall : half_turn;
    const double step = span / static_cast<double>(count_ - 1);
    const double first = angle_of(-forward) - 0.5 * span;
    return loosest([&](double gap) {
      Ring ring{Vec2::Zero(), radius(step, gap, focus_ && !is_around() ? std::max(view, inside_) : inside_), first, step};
      ring.center = focus_ ? at_wall(wall) : roomiest() + 0.5 * ring.radius * forward;
      return ring;
    });
  }

  // Of a ring that is looked at from its things; who sits at a desk looks over it.
  double yaw_at(const Ring& ring, std::size_t number, bool looks_backwards) const {
    const Vec2 inward = ring.center - ring.at(number);
    return yaw_facing(looks_backwards ? Vec2(-inward) : inward);
  }

 private:
  template <typename MakeRing>
  std::optional<Ring> loosest(MakeRing make_ring) const {
    for (const double gap : gaps_beside)
      if (const Ring ring = make_ring(gap); fits(ring)) return ring;
    return std::nullopt;
  }

  double radius(double step, double gap, double inside) const { return radius_of(size_, step, gap, inside); }

  bool fits(const Ring& ring) const {
    const Bounds2 part = floor_of(draft_, room_);
    for (std::size_t n = 0; n < count_; ++n) {
      const Vec2 at = ring.at(n);
      const bool is_in_part = (at.array() >= part.low.array()).all() && (at.array() <= part.high.array()).all();
      if (!is_in_part || !contains(room_.polygon, Footprint(at, size_, yaw_at(ring, n, false)))) return false;
    }
    return true;
  }

  // Farthest from all walls; of those nearest to the middle of that part of the floor.
  Vec2 roomiest() const {
    constexpr double pull = 0.05;  ///< metres of room that a metre nearer to the middle is worth
    const Bounds2 part = floor_of(draft_, room_);
    const Vec2 middle = 0.5 * (part.low + part.high);
    const auto worth = [&](const Vec2& at) {
      return contains(room_.polygon, at) ? distance_to_boundary(room_.polygon, at) - pull * (at - middle).norm() : -1e9;
    };
    Vec2 best = middle;
    for (double x = part.low.x(); x <= part.high.x(); x += places_every)
      for (double y = part.low.y(); y <= part.high.y(); y += places_every)
        if (worth({x, y}) > worth(best)) best = {x, y};
    return best;
  }

  // "a half circle around the stage": close to it, where others look from afar.
  bool is_around() const {
    return std::any_of(
        draft_.demands.begin(), draft_.demands.end(),
        [](const brief::Demand& demand) { return demand.kind == RelationKind::around; });
  }

  Vec2 at_wall(std::size_t wall) const {
    const double depth = focus_->item.size ? focus_->item.size->y() : 0.0;
    return room_.polygon.edge(wall).middle() + 0.5 * depth * room_.polygon.inward(wall);
  }

  Vec2 way_in() const {
    for (const auto& opening : room_.openings)
      if (opening.is_entrance()) return room_.polygon.edge(opening.wall).middle();
    return room_.polygon.edge(0).middle();
  }

  const Draft& draft_;
  std::size_t count_;
  const Draft* focus_;
  const Room& room_;
  Vec2 size_;
  double inside_;  ///< metres from the middle to their fronts, at least
};

// The least costly wall that there is an arc for.
std::optional<std::pair<Ring, std::size_t>> arc_at_some_wall(const RoundFormation& formation, const Draft& draft,
                                                             const std::vector<Draft>& drafts, const Room& room) {
  std::optional<std::pair<Ring, std::size_t>> best;
  double least = 0.0;
  for (std::size_t wall = 0; wall < room.polygon.size(); ++wall) {
    const double cost = cost_of_facing(room, wall, draft, drafts);
    if (best && cost >= least) continue;
    if (const auto ring = formation.arc(wall)) best = {*ring, wall}, least = cost;
  }
  return best;
}

// What a circle stands around is in its middle, unless it was told where else.
void put_focus_in_middle(const Draft* focus, const Vec2& center, const std::vector<Draft>& drafts, Plan& plan) {
  if (!focus || focus->item.mount != Mount::floor) return;
  const bool is_free =
      std::all_of(focus->demands.begin(), focus->demands.end(),
                  [](const brief::Demand& demand) { return demand.kind == RelationKind::middle; });
  if (is_free) plan.items[static_cast<std::size_t>(focus - drafts.data())].location = center;
}

}  // namespace

void lay_out_round(const std::vector<std::size_t>& items, const std::vector<Draft>& drafts, const KindTable& table,
                   Plan& plan) {
  constexpr std::size_t fewest = 3;
  if (items.size() < fewest) return;
  const Draft& draft = drafts[items.front()];
  const Draft* focus = focus_of(draft, drafts);
  const RoundFormation formation(draft, items.size(), focus, plan.room, table);
  std::optional<Ring> ring;
  if (draft.formation->shape == brief::Formation::Shape::circle) {
    ring = formation.circle();
    if (ring) put_focus_in_middle(focus, ring->center, drafts, plan);
  } else if (const auto arc = arc_at_some_wall(formation, draft, drafts, plan.room)) {
    ring = arc->first;
    if (focus) put_focus_at_wall(draft, arc->second, ring->center, 0.0, drafts, plan);
  }
  if (!ring) return;
  const bool looks_backwards = table.is_a(draft.item.category, "table");
  for (std::size_t n = 0; n < items.size(); ++n) {
    PlanItem& item = plan.items[items[n]];
    item.location = ring->at(n);
    item.facing = formation.yaw_at(*ring, n, looks_backwards);
  }
}

double side_for_round(const std::vector<Draft>& drafts, const KindTable& table) {
  double side = 0.0;
  for (const Draft& draft : drafts) {
    if (!draft.formation || !draft.formation->is_round() || !draft.item.size || draft.item.quantity < 3) continue;
    const double turn =
        draft.formation->shape == brief::Formation::Shape::circle ? 2.0 * pi : half_turn;
    const Draft* focus = focus_of(draft, drafts);
    const double inside = focus ? around(focus->item, table) : 0.5 * feet_in_middle;
    const double radius = radius_of(draft.item.size->head<2>(), turn / draft.item.quantity, usual_gap, inside);
    side = std::max(side, 2.0 * radius + draft.item.size->head<2>().norm() + around_all);
  }
  return side;
}

}  // namespace roomgen::plan
