#include "block_site.h"

#include <algorithm>

#include "gathering.h"
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

// "facing the stage"; "a half circle around the fire"
bool means_focus(const brief::Demand& demand, const Draft& block) {
  return is_looking_at(demand.kind) ||
         (demand.kind == RelationKind::around && block.formation && block.formation->is_round());
}

}  // namespace

Bounds2 floor_of(const Draft& draft, const Room& room) {
  for (const auto& demand : draft.demands)
    if (demand.kind == RelationKind::in_part)
      if (const auto region = region_of_room(room, demand.part)) return region->bounds();
  return bounds(room.polygon);
}

std::vector<std::size_t> foci_of(const Draft& block, const std::vector<Draft>& drafts, const KindTable& kinds) {
  std::vector<std::size_t> told, usual;
  const auto is_of_block = [&](const brief::Demand& demand) { return demand.mention == block.mention; };
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    const Draft& one = drafts[i];
    if (!one.item.group.empty() || one.item.quantity != 1 || one.mention == block.mention) continue;
    const bool is_said = one.mention != brief::Demand::none &&
                         std::any_of(block.demands.begin(), block.demands.end(), [&](const brief::Demand& demand) {
                           return demand.mention == one.mention && means_focus(demand, block);
                         });
    const bool is_in_front = one.item.mount != Mount::surface &&
                             std::any_of(one.demands.begin(), one.demands.end(), [&](const brief::Demand& demand) {
                               return demand.kind == RelationKind::in_front_of && is_of_block(demand);
                             });
    if (is_said || is_in_front) told.push_back(i);
    if (one.demands.empty() && kinds.is_any_of(one.item.category, usual_foci())) usual.push_back(i);
  }
  if (!told.empty() || usual.empty() || !kinds.is_any_of(block.item.category, {"seat", "desk"})) return told;
  const auto rank = [&](std::size_t i) {
    const auto& all = usual_foci();
    return std::find_if(all.begin(), all.end(), [&](const auto& kind) { return kinds.is_a(drafts[i].item.category, kind); });
  };
  return {*std::min_element(usual.begin(), usual.end(), [&](auto a, auto b) { return rank(a) < rank(b); })};
}

double cost_of_facing(const Room& room, std::size_t wall, const Draft& block, const std::vector<std::size_t>& foci,
                      const std::vector<Draft>& drafts) {
  double cost = 0.0;
  for (const auto& opening : room.openings)
    if (opening.wall == wall) cost += opening.is_entrance() ? 2.0 : 1.0;
  const std::string name = "wall-" + std::to_string(wall);
  const bool is_told = names_wall(block, name) ||
                       std::any_of(foci.begin(), foci.end(), [&](std::size_t i) { return names_wall(drafts[i], name); });
  if (is_told) cost -= told;
  if (wall == front_wall && std::any_of(drafts.begin(), drafts.end(), is_at_front)) cost -= told_of_others;
  return cost;
}

void put_at_wall(const std::vector<std::size_t>& foci, const Draft& block, std::size_t wall, const Vec2& center,
                 const Room& room, std::vector<Draft>& drafts) {
  const std::string name = "wall-" + std::to_string(wall);
  const auto part = part_of_room(room, name);
  const Vec2 forward = -room.polygon.inward(wall);
  const bool is_round = block.formation && block.formation->is_round();
  for (const std::size_t i : foci) {
    Draft& draft = drafts[i];
    std::erase_if(draft.demands, [&](const brief::Demand& demand) {
      return demand.kind == RelationKind::in_front_of && demand.mention == block.mention;
    });
    if (!draft.demands.empty() || !part) continue;
    PlanItem& item = draft.item;
    const double off = (item.size ? 0.5 * item.size->y() : 0.0) + (item.mount == Mount::floor && !is_round ? margin : 0.0);
    item.location = center + ((part->center() - center).dot(forward) - off) * forward;
    for (const auto kind : {RelationKind::near, RelationKind::face_same_as})
      draft.demands.push_back({.kind = kind, .part = name});
  }
}

}  // namespace roomgen::plan
