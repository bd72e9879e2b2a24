#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "arrangement.h"
#include "collision/solids.h"
#include "collision/support_poses.h"
#include "collision/usability.h"
#include "free_zones.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/problem.h"
#include "roomgen/scene/scene.h"
#include "roomgen/solve/solve.h"
#include "room_limits.h"

namespace roomgen {

/// The footprints of one object at many poses. Remembers each turn: sines and cosines are dear.
class FootprintAt {
 public:
  explicit FootprintAt(const Object& object)
      : size_(object.size.head<2>()), round_(object.traits.round) {}
  Footprint operator()(const Pose& pose) const;

 private:
  Vec2 size_;
  bool round_;
  mutable std::vector<Footprint> turned_;  // one for each yaw seen, at the origin
};

/// A room that is being furnished: what stands where, and fast answers to "may this stand there
/// too?". Nothing that breaks docs/constraints.md ("Valid") gets in through place() and its
/// callers.
class Layout {
 public:
  /// All arguments must outlive the layout. Without arrangements only constraints count, and no kind
  /// prefers one place to another.
  Layout(const Room& room, const KindTable& categories, const ModelTable& models,
         const Arrangements* arrangements = nullptr, const Weights& weights = {});

  const Room& room() const { return room_; }
  const KindTable& categories() const { return categories_; }
  const Weights& weights() const { return weights_; }
  std::span<const Object> objects() const { return objects_; }
  std::span<const FloorThing> things() const { return things_; }
  /// How things of its kind are arranged; null without arrangements.
  const Arrangement* arrangement_of(const Object& object) const;
  /// The same of a group that says so itself.
  const Arrangement* arrangement_of(const PlacementTask& task) const;
  /// The same of things()[i].
  const Arrangement* arrangement_of(std::size_t i) const { return arranged_[i]; }
  const Object* find(std::string_view id) const;
  /// Which keep what they have seen of meshes.
  Solids& solids() { return solids_; }
  /// Where things can rest on others.
  const SupportPoses& support_poses() const { return support_poses_; }
  /// Everywhere on the support, as it stands, where the object fits beside what is there.
  std::vector<Pose> free_support_poses(const Object& object, const Object& support) const;
  /// Does anything stand on the thing?
  bool carries_something(std::string_view id) const;
  /// Yaws at which a thing stands square to some wall, each quarter turn, without repetition; of very many a sample.
  std::span<const double> wall_yaws() const { return wall_yaws_; }

  /// Can somebody get in by every door while nothing stands here? Else nothing on the floor is of use, wherever it stands.
  bool has_way_in() const { return has_way_in_; }

  /// The clearances of doors and passages.
  std::span<const Footprint> door_areas() const { return limits_.door_areas(); }
  /// The strips before windows where the object, from the floor up, is too high to stand.
  std::vector<Footprint> areas_before_windows(const Object& object) const {
    return limits_.areas_before_windows(object);
  }

  void add(Object object);
  void remove(std::string_view id);
  void clear();

  /// What can be said of a thing before its pose is known, for many calls of fits().
  struct Candidate {
    Object object;  ///< with any pose
    const Kind* category = nullptr;
    /// What is placed together with it, each in its frame.
    struct Companion;
    std::vector<Companion> companions = {};
    bool even_useless = false;  ///< as PlaceOptions has it
    bool by_meshes = false;     ///< boxes may overlap where the meshes do not
  };
  Candidate candidate(const Object& object) const;
  Candidate candidate(const PlacementTask& task) const;

  /// The cheap test, of companions too: inside, boxes apart, openings free. Boxes that overlap pass
  /// only where one thing may slide under the other; fits_exactly() then asks the meshes.
  bool fits(const Candidate& candidate, const Footprint& footprint, double bottom) const;
  /// The two halves of fits(): the room itself, and one other thing.
  bool fits_room(const Candidate& candidate, const Footprint& footprint, double bottom) const;
  bool collides(const Candidate& candidate, const Footprint& footprint, double bottom,
                const FloorThing& other) const;
  /// The answer of fits_exactly().
  struct Verdict {
    bool fits = true;
    /// If not, some of things() one of which would have to stand elsewhere; none if that is not
    /// clear.
    std::vector<std::size_t> blamed = {};
    /// The one of things() that nobody could use; as large as their number: the newcomer.
    std::optional<std::size_t> useless = {};

    explicit operator bool() const { return fits; }
  };
  /// The rest, for an object with its pose: meshes, and everybody's use zones and the doors stay
  /// reachable.
  Verdict fits_exactly(const Candidate& candidate);
  /// May the two overlap as boxes because one slides under the other?
  bool may_tuck(const Kind& a, const Kind& b) const;

 private:
  bool fits_alone(const Candidate& candidate, const Footprint& footprint, double bottom) const;
  Verdict fits_alone_exactly(const Candidate& candidate);
  bool rests_on(const Object& upper, const Object& lower) const;
  bool may_sit_over(const Object& object, const Kind& other) const;
  void refresh_things();
  void bring_occupancy_up_to_date();
  Verdict all_have_a_free_zone() const;
  bool keeps_free_zone(std::size_t i) const;
  bool is_usable_still(std::size_t i) const;
  Verdict all_are_usable_with(const Footprint& newcomer, bool even_useless);
  Verdict blame(std::size_t useless) const;

  const Room& room_;
  const KindTable& categories_;
  const ModelTable& models_;
  const Arrangements* arrangements_;
  Weights weights_;
  Solids solids_;
  SupportPoses support_poses_;
  std::vector<double> wall_yaws_;
  RoomLimits limits_;
  std::vector<Object> objects_;
  std::vector<FloorThing> things_;
  std::vector<const Arrangement*> arranged_;  ///< parallel to objects_
  OccupancyGrid occupancy_;
  bool has_way_in_ = true;
  FreeZones free_zones_;  ///< of objects_
  /// Parallel to objects_; stamped only when an exact test needs it.
  std::vector<bool> in_occupancy_;
};

struct Layout::Candidate::Companion {
  Candidate self;
  Vec2 position = Vec2::Zero();
  double yaw = 0.0;
};

/// The object at a pose, rounded as files hold it: what is tested is what is written.
Object at_pose(const Object& object, const Pose& pose);

/// The height of the bottom of what hangs on a wall (at its usual `elevation`) or under the ceiling;
/// 0 for what stands.
double mounting_height(Mount mount, double height, double elevation, const Room& room);

/// A support pose of an object on another one, in the room.
Pose pose_of(const SupportPose& support_pose, const Object& support);

}  // namespace roomgen
