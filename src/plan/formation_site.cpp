#include "formation_site.h"

#include <algorithm>

#include "scene/room_part.h"

namespace roomgen::plan {

namespace {

constexpr double told = 10.0, told_of_others = 5.0;  ///< off the cost of facing a wall
constexpr std::size_t front_wall = 0;                ///< of a rectangle: "at the front"

bool names_wall(const Draft& draft, const std::string& wall) {
  return std::any_of(draft.demands.begin(), draft.demands.end(),
                     [&](const brief::Demand& demand) { return demand.part == wall; });
}

// "a lectern at the front": the front wall, or that part of the room.
bool is_at_front(const Draft& draft) {
  return !draft.formation && (names_wall(draft, "wall-0") || names_wall(draft, "south-half") || names_wall(draft, "south-third"));
}

}  // namespace

Bounds2 floor_of(const Draft& draft, const Room& room) {
  for (const auto& demand : draft.demands)
    if (demand.kind == RelationKind::in_part)
      if (const auto region = region_of_room(room, demand.part)) return region->bounds();
  return bounds(room.polygon);
}

bool faces_something(const Draft& draft) {
  return std::any_of(draft.demands.begin(), draft.demands.end(), [](const brief::Demand& demand) {
    return is_looking_at(demand.kind);
  });
}

const Draft* focus_of(const Draft& draft, const std::vector<Draft>& drafts) {
  for (const brief::Demand& demand : draft.demands) {
    const bool is_meant = is_looking_at(demand.kind) || demand.kind == RelationKind::around;
    if (!is_meant || demand.mention == brief::Demand::none || demand.mention == draft.mention)
      continue;
    for (const Draft& other : drafts)
      if (other.mention == demand.mention && other.item.quantity == 1) return &other;
  }
  return nullptr;
}

double cost_of_facing(const Room& room, std::size_t wall, const Draft& draft, const std::vector<Draft>& drafts) {
  double cost = 0.0;
  for (const auto& opening : room.openings)
    if (opening.wall == wall) cost += opening.is_entrance() ? 2.0 : 1.0;
  const std::string name = "wall-" + std::to_string(wall);
  const Draft* focus = focus_of(draft, drafts);
  if (names_wall(draft, name) || (focus && names_wall(*focus, name))) cost -= told;
  if (wall == front_wall && std::any_of(drafts.begin(), drafts.end(), is_at_front)) cost -= told_of_others;
  return cost;
}

void put_focus_at_wall(const Draft& audience, std::size_t wall, const Vec2& center, double off_wall,
                       const std::vector<Draft>& drafts, Plan& plan) {
  const std::string name = "wall-" + std::to_string(wall);
  const auto part = part_of_room(plan.room, name);
  const Vec2 forward = -plan.room.polygon.inward(wall);
  for (const auto& demand : audience.demands) {
    const bool is_meant = is_looking_at(demand.kind) ||
                          (demand.kind == RelationKind::around && audience.formation && audience.formation->is_round());
    if (!is_meant || demand.mention == brief::Demand::none || !part) continue;
    for (std::size_t i = 0; i < drafts.size(); ++i) {
      if (drafts[i].mention != demand.mention || !drafts[i].demands.empty()) continue;
      PlanItem& item = plan.items[i];
      const double depth = item.size ? item.size->y() : 0.0;
      const double to_wall = (part->center() - center).dot(forward);
      item.location = center + (to_wall - 0.5 * depth - (item.mount == Mount::floor ? off_wall : 0.0)) * forward;
      for (const auto kind : {RelationKind::near, RelationKind::face_same_as}) item.relations.push_back({kind, name});
    }
  }
}

}  // namespace roomgen::plan
