#pragma once

#include <string>
#include <vector>

#include "roomgen/scene/scene.h"

namespace rooms {

using namespace roomgen;

/// A rectangle from the origin, without openings.
inline Room box(double width, double depth, double height = default_room_height) {
  Room room;
  room.type = "test";
  room.height = height;
  room.polygon.points = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
  return room;
}

inline Opening door(const std::string& id, std::size_t wall, double from, double to) {
  Opening opening;
  opening.id = id;
  opening.wall = wall;
  opening.from = from;
  opening.to = to;
  return opening;
}

inline Opening window(const std::string& id, std::size_t wall, double from, double to) {
  Opening opening = door(id, wall, from, to);
  opening.type = OpeningType::window;
  opening.sill = default_sill;
  opening.head = default_window_head;
  return opening;
}

/// A thing that stands on the floor; `yaw` in degrees.
inline Object thing(const std::string& id, const std::string& category, const Vec3& size,
                    const Vec2& at = Vec2::Zero(), double yaw = 0.0) {
  Object object;
  object.id = id;
  object.category = category;
  object.size = size;
  object.position = {at.x(), at.y(), 0.0};
  object.yaw = radians(yaw);
  return object;
}

inline Scene scene(Room room, std::vector<Object> objects) {
  Scene result;
  result.room = std::move(room);
  result.objects = std::move(objects);
  return result;
}

/// The whole thing turned by `angle` radians around the origin and moved.
inline Vec2 moved(const Vec2& p, double angle, const Vec2& shift) {
  return rotated(p, angle) + shift;
}
inline Object moved(Object object, double angle, const Vec2& shift) {
  object.position.head<2>() = moved(Vec2(object.position.head<2>()), angle, shift);
  object.yaw += angle;
  return object;
}
inline Room moved(Room room, double angle, const Vec2& shift) {
  for (auto& point : room.polygon.points) point = moved(point, angle, shift);
  return room;
}
inline Scene moved(Scene scene, double angle, const Vec2& shift) {
  scene.room = moved(scene.room, angle, shift);
  for (auto& object : scene.objects) object = moved(object, angle, shift);
  return scene;
}

}  // namespace rooms
