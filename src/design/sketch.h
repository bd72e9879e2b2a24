#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "arrangement.h"
#include "roomgen/geometry/footprint.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/scene.h"

namespace roomgen::design {

struct Pose {
  Vec2 position = Vec2::Zero();
  double yaw = 0.0;
  double merit = 0.0;  ///< that the way it was found gives it
};

/// Anything that a relation can name: an object, an opening or a wall (those have no depth and look
/// into the room).
struct Target {
  std::string id;
  Footprint footprint;
  double bottom = 0.0;
  double top = 0.0;
  const Object* object = nullptr;  ///< null for parts of the room
};

/// An object that stands in the room, with what is known about its kind.
struct Standing {
  const Object* object = nullptr;
  Footprint footprint;
  const Kind* category = nullptr;
  const Arrangement* arrangement = nullptr;
  std::vector<UseZone> zones;  ///< those that are free now
};

/// The room as a designer sees it from above: boxes, the floor that their use needs, and the walls.
/// It is coarser than the solver: no meshes, so what it allows is nearly always possible.
class Sketch {
 public:
  /// `scene` must outlive the sketch.
  Sketch(const Scene& scene, const KindTable& categories, const Arrangements& arrangements);

  const Room& room() const { return *room_; }
  const KindTable& categories() const { return *categories_; }
  std::span<const Object> objects() const { return objects_; }
  const std::vector<Standing>& standing() const { return standing_; }

  /// True if `self` can be there, at height `bottom`: inside, apart from solids and from doors and
  /// windows, itself usable, and no other thing made useless.
  bool allows(const Object& self, const Pose& pose, double bottom) const;

  /// True if a solid or the clearance of a door is there.
  bool blocked(const Footprint& footprint) const;

  /// The object, opening or wall of that id.
  std::vector<Target> find(std::string_view id) const;
  /// All doors and passages, or all windows.
  std::vector<Target> openings(bool entrances) const;
  Target wall(std::size_t k) const;

 private:
  bool clear_of_solids(const Object& self, const Footprint& footprint, double bottom) const;
  bool clear_of_openings(const Object& self, const Footprint& footprint, double bottom) const;
  bool zone_free(const Footprint& zone, const UseZone& needs, const Object* owner) const;
  bool usable(const Object& self, const Footprint& footprint) const;
  bool leaves_others_usable(const Object& self, const Footprint& footprint, double bottom) const;

  const Room* room_;
  std::span<const Object> objects_;
  const KindTable* categories_;
  std::vector<Standing> standing_;
  std::vector<Footprint> door_strips_;
  std::vector<std::pair<Footprint, double>> window_strips_;  ///< and the height they allow
};

/// The footprint of an object at a pose.
inline Footprint footprint_at(const Object& object, const Pose& pose) {
  return Footprint(pose.position, object.size.head<2>(), pose.yaw, object.traits.round);
}

/// Height of the bottom of an object that neither stands on another nor hangs under the ceiling.
double usual_bottom(const Object& object, const Kind& category, const Room& room);

}  // namespace roomgen::design
