#include "roomgen/scene/scene.h"

#include <set>

#include "dwelling.h"

namespace roomgen {

namespace {

Error object_error(const Object& object, const std::string& what) {
  return {Error::Kind::invalid_input, "object \"" + object.id + "\": " + what};
}

// What stands on a thing, and that on another, stands on the floor in the end. Precondition: ids are unique.
Status check_supports(const std::vector<Object>& objects) {
  std::map<std::string_view, const Object*> by_id;
  for (const auto& object : objects) by_id.emplace(object.id, &object);
  std::set<const Object*> held;
  for (const auto& object : objects) {
    std::vector<const Object*> way;
    for (const Object* at = &object; at->mount == Mount::surface && !held.count(at);) {
      if (way.size() == objects.size()) return object_error(object, "stands on itself, or on what stands on it");
      way.push_back(at);
      const auto below = by_id.find(at->on);
      if (below == by_id.end()) return object_error(*at, "stands on \"" + at->on + "\", which is not in the scene");
      at = below->second;
    }
    held.insert(way.begin(), way.end());
  }
  return {};
}

}  // namespace

const Object* find_object(std::span<const Object> objects, std::string_view id) {
  for (const auto& object : objects)
    if (object.id == id) return &object;
  return nullptr;
}

const Object* find_object(const Scene& scene, std::string_view id) {
  return find_object(scene.objects, id);
}

Object* find_object(Scene& scene, std::string_view id) {
  return const_cast<Object*>(find_object(static_cast<const Scene&>(scene), id));
}

std::span<const Room> rooms_of(const Scene& scene) {
  if (scene.rooms.empty()) return {&scene.room, 1};
  return scene.rooms;
}

const Room& room_of(const Scene& scene, const Object& object) {
  const Room* room = find_room(scene.rooms, object.room);
  return room ? *room : rooms_of(scene).front();
}

std::vector<Scene> parts_of(const Scene& scene) {
  if (scene.rooms.empty()) return {scene};
  std::vector<Scene> parts;
  for (const auto& room : scene.rooms) {
    Scene part;
    part.prompt = scene.prompt;
    part.seed = scene.seed;
    part.incomplete = scene.incomplete;
    part.room = room;
    for (const auto& object : scene.objects)
      if (object.room == room.id) part.objects.push_back(object);
    parts.push_back(std::move(part));
  }
  return parts;
}

Status check(const Scene& scene) {
  if (auto status = scene.rooms.empty() ? check(scene.room) : check_dwelling(scene.rooms); !status)
    return status;
  std::set<std::string, std::less<>> ids;
  for (const auto& object : scene.objects) {
    if (object.id.empty()) return object_error(object, "has no id");
    if (!ids.insert(object.id).second) return object_error(object, "there are two of this id");
    if (!(object.size.minCoeff() > 0)) return object_error(object, "its size must be positive");
    if (!scene.rooms.empty() && !find_room(scene.rooms, object.room))
      return object_error(object, "is in room \"" + object.room + "\", which the dwelling does not have");
    for (const auto& relation : object.relations)
      if (relation.target == object.id) return object_error(object, "cannot be \"" + to_text(relation) + "\"");
  }
  return check_supports(scene.objects);
}

}  // namespace roomgen
