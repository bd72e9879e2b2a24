#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/random.h"
#include "composition/arrange.h"
#include "roomgen/generate/generate.h"
#include "roomgen/scene/problem.h"

namespace roomgen {

/// The things of a group as they will be: each with an asset, before any stands.
struct Cast {
  struct Thing {
    AssetInfo asset;
    PlacementTask task;
  };
  std::map<std::pair<std::string, std::size_t>, std::string> ids;  ///< by part and number
  std::map<std::string, Thing> things;                             ///< by id

  /// Empty: no thing of the plan.
  std::string id_of(const composition::Member& member) const;
  const Object* object_of(const composition::Member& member) const;
};

/// A group of the plan that stands in one of its ways: where its members go when their turn comes.
struct StandingGroup {
  std::string id;  ///< the plan's
  bool is_whole = true;  ///< not only one of the groups within it
  struct Post {
    composition::Place place;  ///< in its frame
    std::string carrier;       ///< of what stands on another
    bool spread = false;       ///< Member::spread
    std::size_t refused = 0;   ///< how often there was no room for it
  };
  std::map<std::string, Post> posts;  ///< of its members, by id
  PlacementTask anchor;               ///< with its companions
  std::shared_ptr<const Cast> cast;
  bool even_useless = false;  ///< as PlaceOptions has it
};

/// A rug where a designer put it, and where it lies among what stands now.
struct LaidRug {
  Object said, lies;
};

/// How far a room has come: all that steps change. Copies are cheap (meshes are shared) and are what undo
/// goes back to; equal states go on equally.
struct BuildState {
  std::vector<Object> objects;           ///< that stand, in the order of placement
  std::vector<PlannedObject> left;       ///< still to be tried, in the plan's order
  std::string next;                      ///< of them, what the designer wants next
  std::vector<PlacementTask> tasks;      ///< of all objects that have an asset, in order
  std::map<std::string, std::string> reasons;   ///< why objects do not stand
  std::set<std::size_t> hopeless_items;         ///< of which one found no place
  std::vector<StandingGroup> groups;            ///< that stand
  std::set<std::string> tried_groups;           ///< by id
  /// Groups within groups that found no place as one, by the id of their anchor: still to be tried.
  std::map<std::string, composition::Arranged> units;
  std::map<std::string, LaidRug> rugs;  ///< of designers, by id
  std::map<std::string, PlanItem> amended;      ///< by object: what the designer says otherwise than its item
  std::map<std::string, AssetInfo> assets;      ///< by object
  std::map<std::string, AssetInfo> favourites;  ///< by what was asked for (retrieve.h)
  ModelTable models;                            ///< of what stands and what was tried
  std::vector<Step> trace;
  std::vector<Move> moved;  ///< by improvements of the whole room
  ModelUse model_use;
  std::string stopped;      ///< why the designer may not be asked any more
  bool is_cut = false;      ///< an improvement ran out of time
  Random random{0};
};

/// Removes an object from what is still to be tried.
void take_up(BuildState& state, std::string_view id);

}  // namespace roomgen
