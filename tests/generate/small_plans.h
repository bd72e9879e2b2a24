#pragma once

#include <string>
#include <utility>
#include <vector>

#include "roomgen/scene/plan.h"
#include "support/rooms.h"

namespace rooms {

inline PlanItem item(const std::string& category, Mount mount = Mount::floor, int quantity = 1) {
  PlanItem result;
  result.category = category;
  result.mount = mount;
  result.quantity = quantity;
  return result;
}

inline Plan plan_of(std::vector<PlanItem> items, Room room) {
  Plan plan;
  plan.prompt = "a test";
  plan.room = std::move(room);
  plan.items = std::move(items);
  return plan;
}

inline Room room_with_door(double width, double depth) {
  Room room = box(width, depth);
  room.openings = {door("door-0", 0, 0.3, 1.2)};
  return room;
}

inline PlanItem member(const std::string& category, const std::string& part, const Vec3& size) {
  PlanItem item = rooms::item(category);
  item.group = "seats", item.part = part;
  item.size = size;
  item.asked = true;
  return item;
}

// A desk of 1.2 m with a stool at a place of its frame.
inline Plan desk_and_stool(const Vec2& desk, const std::string& stool) {
  Plan plan = plan_of({member("desk", "desk", {1.2, 0.6, 0.75}),
                              member("stool", "stool", {0.4, 0.4, 0.5})},
                             room_with_door(5, 4));
  PlanGroup group;
  group.id = "seats";
  group.definition = R"({"parts": [{"part": "desk", "kind": "desk"},
      {"part": "stool", "kind": "stool", "of": "desk", "at": )" + stool + "}]}";
  group.location = desk;
  group.facing = 0.0;
  plan.groups = {group};
  return plan;
}

}  // namespace rooms
