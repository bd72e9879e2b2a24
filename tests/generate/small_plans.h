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

}  // namespace rooms
