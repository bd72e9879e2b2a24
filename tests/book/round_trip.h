#pragma once
// Rooms become designs, and designs plans: where the plan puts things, without a solver.

#include <nlohmann/json.hpp>

#include "book/design.h"
#include "brief/room_kinds.h"
#include "brief/said_wish.h"
#include "catch.h"
#include "composition/plan_groups.h"
#include "design/plan_reply.h"
#include "roomgen/design/designer.h"

namespace roomgen::test {

struct Spot {
  std::string category;
  Vec2 at = Vec2::Zero();
  double yaw = 0.0;
  Vec3 size = Vec3::Ones();
  Mount mount = Mount::floor;
};

/// What a plan says of where things stand: the members of groups, and single things with a place.
inline std::vector<Spot> spots_of(const Plan& plan) {
  const KindTable& kinds = KindTable::built_in();
  std::vector<Spot> spots;
  for (const auto& item : plan.items)
    if (item.group.empty() && item.location)
      spots.push_back(
          {item.category, *item.location, item.facing.value_or(0.0), *item.size, item.mount});
  for (const auto& group : plan.groups) {
    const auto ways = composition::ways_to_stand(plan, group, kinds, {});
    REQUIRE(ways);
    const composition::Place frame{group.location.value_or(Vec2::Zero()),
                                   group.facing.value_or(0.0)};
    for (const auto& member : ways->front().members) {
      const auto place = composition::within(frame, member.place);
      spots.push_back({member.category, place.position, place.yaw, member.size, member.mount});
    }
  }
  return spots;
}

/// Of a room of that size after a design, not turned.
inline Plan plan_of(const Json& json, const Vec2& size, bool is_mirrored = false) {
  const auto design = book::read_design(json, "test");
  if (!design) FAIL(design.error().message);
  book::Setting setting;
  setting.values = book::default_values(*design);
  setting.size = size, setting.is_mirrored = is_mirrored;
  if (!design->palettes.empty()) setting.palette = design->palettes.front();
  const auto answer = book::answer_of(*design, setting);
  if (!answer) FAIL(answer.error().message);
  PlanRequest request;
  request.prompt = "a room";
  request.size = size;
  const KindTable& kinds = KindTable::built_in();
  auto parts = design::read_plan_parts(
      *answer, request, brief::brief_of(request, *brief::built_in_room_kinds(), kinds), kinds);
  if (!parts) FAIL(parts.error().message);
  Plan plan;
  plan.room = parts->room;
  plan.notes = parts->repairs;
  for (const auto& draft : parts->drafts) plan.items.push_back(draft.item);
  plan.groups = parts->groups;
  composition::complete_groups(plan, kinds);
  return plan;
}

/// The things of a room that stand on its floor, and those of them that a plan has elsewhere.
struct Compared {
  int floor = 0;
  std::vector<std::string> elsewhere;
};

inline Compared compared(const Scene& scene, const Plan& plan) {
  constexpr double close = 0.10, turn = 5.0;
  const Vec2 low = bounds(scene.room.polygon).low;
  auto spots = spots_of(plan);
  Compared result;
  for (const auto& object : scene.objects) {
    if (object.mount != Mount::floor) continue;
    ++result.floor;
    const Vec2 at = object.position.head<2>() - low;
    const auto found = std::find_if(spots.begin(), spots.end(), [&](const Spot& spot) {
      const bool looks_alike =
          !object.traits.front || std::abs(degrees(wrap_angle(spot.yaw - object.yaw))) <= turn;
      return spot.category == object.category && (spot.at - at).norm() <= close && looks_alike;
    });
    if (found == spots.end())
      result.elsewhere.push_back(object.id);
    else
      spots.erase(found);
  }
  return result;
}

}  // namespace roomgen::test
