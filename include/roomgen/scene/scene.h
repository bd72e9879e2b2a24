#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"
#include "roomgen/scene/object.h"
#include "roomgen/scene/requirement.h"
#include "roomgen/scene/room.h"

namespace roomgen {

struct Unplaced {
  std::string id;
  std::string category;
  std::string reason;  ///< for people
};

/// What became of a constraint of the program (roomgen/lab/program.h) that a scene was made by.
struct ProgramVerdict {
  std::string name;
  bool held = false;
  double amount = 0.0;  ///< by which it is missed
};

/// A furnished room, or a dwelling of several: the one source of truth for every export, picture,
/// edit and figure. A dwelling has its rooms in `rooms`, in one common frame, and `room` stays
/// empty; each object names its room. Ids of objects are unique in the whole dwelling, ids of
/// openings in their room: what a relation says is meant in the object's room.
struct Scene {
  std::string prompt;
  std::uint64_t seed = 0;
  bool incomplete = false;  ///< the work was stopped before all objects were tried
  Room room;
  std::vector<Object> objects;
  std::vector<Unplaced> unplaced;
  std::vector<RequirementVerdict> requirements;  ///< what the prompt asked for, met or not
  std::vector<Heard> heard;                      ///< what its words were taken for
  std::vector<ProgramVerdict> program;           ///< of a scene that a constraint program made
  std::vector<Room> rooms;  ///< of a dwelling
};

inline constexpr std::size_t max_rooms = 12;  ///< of a dwelling

/// The one room, or those of the dwelling.
std::span<const Room> rooms_of(const Scene& scene);
/// One room of a scene with what stands in it, as a scene of its own: what is true of single rooms
/// is asked of each part. A scene of one room has itself as its only part.
std::vector<Scene> parts_of(const Scene& scene);

/// The room that an object of the scene is in.
const Room& room_of(const Scene& scene, const Object& object);

const Object* find_object(std::span<const Object> objects, std::string_view id);
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
Result<Room> read_room_file(const std::filesystem::path& path);

/// The meshes of a scene, by asset_key(). Models are shared, not copied; an object without a model
/// counts as its box.
class ModelTable {
 public:
  void add(const std::string& key, std::shared_ptr<const Model> model);
  /// Null if there is none.
  std::shared_ptr<const Model> find(std::string_view key) const;
  bool empty() const { return models_.empty(); }

 private:
  std::map<std::string, std::shared_ptr<const Model>, std::less<>> models_;
};

/// Maps model coordinates to the room: p_room = R(yaw) * (scale * p_model) + position. The scale,
/// axis by axis, makes the model's box exactly `object.size`.
struct ModelPlacement {
  Vec3 scale = Vec3::Ones();
  double yaw = 0.0;
  Vec3 position = Vec3::Zero();
};
ModelPlacement model_placement(const Object& object, const Bounds3& model_bounds);

/// Does the model, at a size in metres, stay within the ellipse inscribed in its box from above, by
/// a centimetre? Only then may an object that is made of it be `round`.
bool keeps_to_ellipse(const Model& model, const Vec3& size);

}  // namespace roomgen
