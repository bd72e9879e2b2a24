#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/random.h"
#include "roomgen/base/cancel.h"
#include "roomgen/generate/generate.h"
#include "roomgen/scene/scene.h"
#include "workshop.h"

namespace roomgen {

/// A thing and all that goes where it goes: what stands on it, directly or on what does, and of the anchor of a group
/// its members and what stands on them.
struct Cluster {
  Object root;
  std::vector<Object> carried;  ///< each after what carries it

  std::set<std::string> ids() const;
};
/// The thing with what stands on it.
Cluster cluster_of(const Scene& scene, const Object& root);
/// And with its group (docs/groups.md), if it is the anchor of one.
Cluster whole_of(const Scene& scene, const Object& root);
/// The first of its group, which stands for it; itself where it is in none.
const Object& anchor_of(const Scene& scene, const Object& object);
bool is_anchor(const Scene& scene, const Object& object);
/// With the root at another pose, and the rest as it stands on it.
Cluster moved_to(const Cluster& cluster, const Pose& pose);
/// With what it carries.
Cluster in_room(Cluster cluster, const std::string& room);
Pose pose_of(const Object& object);

/// A scene while an edit is at work on it. Given up, it leaves nothing behind.
struct Draft {
  Draft(Workshop& the_shop, const Scene& the_scene, bool may_repair, CancelToken the_cancel)
      : shop(the_shop), scene(the_scene), repair(may_repair), cancel(std::move(the_cancel)),
        random(Random(the_scene.seed).fork("edit")) {}

  Workshop& shop;
  Scene scene;
  const Scene* earlier = nullptr;  ///< before the last edit; null if there was none
  bool repair = true;
  CancelToken cancel;  ///< the search for places ends with it
  Random random;
  std::set<std::string> named;  ///< objects that the edit is about, whatever became of them
  std::vector<std::string> added;
  std::vector<std::string> told;  ///< what whoever asked should know of it
  std::vector<Move> repairs;
  std::vector<Requirement> wishes;       ///< that the edit adds, without ids
  std::set<std::string> new_categories;  ///< of which it brought or took something
  std::set<std::string> new_measures;    ///< of the room: Requirement::attribute

  /// Writes the poses into the scene; new things come to its end.
  void put(const Cluster& cluster);
  void take_out(const std::set<std::string>& ids);
  /// All that a copy of this draft came to; the random numbers go on as they were.
  void take_over(Draft&& trial);
  /// What stands in the room, but for a cluster.
  Layout& layout_without(const Cluster& cluster) { return shop.layout(scene, cluster.root.room, cluster.ids()); }
};

/// The object of this id; not_found, with the nearest name, if there is none.
Result<Object> object_named(const Draft& draft, std::string_view id);
/// The same for what an edit is to change: not if it is locked. It counts as named from now on.
/// `in_place`: it goes, or becomes another one where it is, as may_go().
Result<Object> object_to_change(Draft& draft, std::string_view id, bool in_place = false);
/// Not locked; what covers a window is locked in its place alone.
bool may_go(const Draft& draft, const Object& object);
/// The room of this id, or the only one.
Result<std::string> room_named(const Draft& draft, const std::string& id);

/// The room of this id; empty: the only one.
const Room& room_with_id(const Scene& scene, const std::string& id);
Room& room_with_id(Scene& scene, const std::string& id);

/// Puts things back into the order that they had: what was taken out for a while came to the end.
void restore_order(const std::vector<Object>& before, std::vector<Object>& objects);

Error cannot(const std::string& what);

}  // namespace roomgen
