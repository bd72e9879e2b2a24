#pragma once

#include <optional>
#include <vector>

#include "draft.h"
#include "roomgen/scene/problem.h"

namespace roomgen {

/// Where a thing is wanted.
struct Aim {
  std::vector<Relation> asked;     ///< all must hold in the end
  std::vector<Relation> kept;      ///< that it has already; may be lost
  std::optional<Pose> near_to;     ///< stays within `most_off` of it
  double most_off = 0.5;           ///< metres
  bool turns_freely = false;       ///< else it keeps the yaw of `near_to`
  std::vector<Pose> except = {};   ///< none that is like one of these
  bool usual = false;              ///< where things of its kind stand, as far as all this leaves it open
};

/// Things stand on rugs with all their feet or none. Where that cannot be, what somebody wants
/// exactly so may stand on a rug's edge, and then stands on the floor.
enum class RugEdges { kept_free, stood_on };

/// May the cluster stand as it is (docs/constraints.md, "Valid")? It is not in the layout. Comes
/// back at the height of the rug that it stands on.
Result<Cluster> settled(const Draft& draft, Layout& layout, Cluster cluster, RugEdges edges = RugEdges::kept_free);
/// At this pose, exactly.
Result<Cluster> exactly_at(Draft& draft, const Cluster& cluster, const Pose& pose,
                           RugEdges edges = RugEdges::kept_free);
inline constexpr double furthest_way = 4.0;  ///< metres that a thing may be moved for others, a wall or a door

enum class Effort {
  brief,    ///< the solver's usual search
  thorough  ///< and then all points of the floor 5 cm apart
};
/// At the best of the poses that there are.
Result<Cluster> find_place(Draft& draft, Layout& layout, const Cluster& cluster, const Aim& aim,
                           Effort effort = Effort::thorough);
/// The thing that these relations hang something from; null if none.
const Object* hook_of(const Scene& scene, const std::vector<Relation>& relations);
/// What is to hang from a thing hangs right under it then, with no wires of its own.
Result<Cluster> hung(Draft& draft, Cluster cluster, const std::vector<Relation>& relations);
/// Exactly there, or else as near as there is room, or else there on the edge of a rug.
Result<Cluster> there_or_near(Draft& draft, const Cluster& cluster, const Pose& pose, double most_off);

/// Those of the relations that do not hold for the object as it stands.
std::vector<Relation> lost_relations(const Object& object, const std::vector<Relation>& relations, const Scene& scene,
                                     const KindTable& kinds);
/// The others.
std::vector<Relation> held_relations(const Object& object, const std::vector<Relation>& relations, const Scene& scene,
                                     const KindTable& kinds);
/// Near what an aim is: the place itself, or what it is to stand to, or the middle of the room.
Vec2 middle_of(const Draft& draft, const Layout& layout, const Aim& aim);
/// "sofa-0 stands on the edge of rug-0", for all that did not do so before.
std::vector<std::string> new_rug_edges(const Scene& before, const Draft& draft);
/// Sets what stands on the floor of a room to the height of the rugs that lie there now.
void settle_heights(Draft& draft, const std::string& room);

/// find_place() in the draft's room; where there is no room, a bounded repair: as few unlocked
/// neighbours as can be, up to three, move as little as can be, and all their relations and all
/// requirements that held still hold. What moved is in the draft, and in Draft::repairs. If even
/// that fails, the error names the smallest set of up to three neighbours without which there would
/// be a place. The cluster is put into the draft.
Status place_or_make_way(Draft& draft, const Cluster& cluster, const Aim& aim);

/// All points of the floor 5 cm apart where a thing of the cluster's root fits by its box, square
/// to the walls or turned as the aim says, the nearest to `middle` first: what is left to look at
/// when no pose with a meaning will do.
std::vector<Pose> floor_points(const Layout& layout, const Object& root, const Aim& aim, const Vec2& middle);

}  // namespace roomgen
