#pragma once

#include <optional>
#include <span>
#include <vector>

#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// Which offset "aligned" means, from the other relations with the same target.
enum class AlignAxis { either, lateral, longitudinal };

/// A relation whose target has been looked up, ready to judge many poses of one object.
struct ResolvedRelation {
  RelationKind kind = RelationKind::edge;
  std::vector<Footprint> targets;  ///< one; several for "corner", of which the best counts; none
                                   ///< when the target is not there: then no pose can hold it
  double target_bottom = 0.0;      ///< vertical range of the target, metres above the floor
  double target_top = 0.0;
  double gap_low = 0.0;  ///< preferred range of the gap
  double gap_high = 0.5;
  AlignAxis axis = AlignAxis::either;
  std::optional<Footprint> other;  ///< of `between`: the second of the two
  double least_gap = 0.0;  ///< from which `near` holds
  double turn = 0.0;  ///< of `used_facing`: from its front to where its user looks, radians
  bool is_of_nearest_wall = false;  ///< a gap: to whichever wall is nearest
  bool at_back = false;  ///< the target is a wall, at which the object hangs or is to hang
  bool stands = false;   ///< the object stands on something, and hangs from nothing
};

/// Looks up the targets of an object's relations among the placed objects and the parts of the
/// room, in the order of the relations.
std::vector<ResolvedRelation> resolve(const Object& object, const Room& room,
                                      std::span<const Object> placed,
                                      const KindTable& categories);

/// What "facing" means of a kind: `used facing` unless its user looks where its front does.
RelationKind facing_of_use(const Kind& kind);

/// Those of the relations whose targets are there.
std::vector<Relation> known_relations(const std::vector<Relation>& relations, const Room& room,
                                      std::span<const Object> placed);

}  // namespace roomgen
