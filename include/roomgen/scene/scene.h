#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/scene/object.h"
#include "roomgen/scene/requirement.h"
#include "roomgen/scene/room.h"

namespace roomgen {

struct Unplaced {
  std::string id;
  std::string category;
  std::string reason;  ///< for people
};

/// A furnished room: the one source of truth for every export, picture, edit and figure.
struct Scene {
  std::string prompt;
  std::uint64_t seed = 0;
  bool incomplete = false;  ///< the work was stopped before all objects were tried
  Room room;
  std::vector<Object> objects;
  std::vector<Unplaced> unplaced;
  std::vector<RequirementVerdict> requirements;  ///< what the prompt asked for, met or not
};

const Object* find_object(const Scene& scene, std::string_view id);
Object* find_object(Scene& scene, std::string_view id);

/// Ids are unique, `on` names an object, sizes are positive, the room is sound. Says nothing about
/// collisions: see evaluate/report.h.
Status check(const Scene& scene);

/// scene.json (docs/scene.schema.json). Reading reports the first problem with its JSON pointer.
Json to_json(const Scene& scene);
Result<Scene> scene_from_json(const Json& json, const std::string& source);
Result<Scene> read_scene(const std::filesystem::path& path);

/// The "room" part of scene.json, also a file of its own (docs/room.schema.json).
Json to_json(const Room& room);
Room read_room(const JsonReader& json);
Result<Room> read_room_file(const std::filesystem::path& path);

}  // namespace roomgen
