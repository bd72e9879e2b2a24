#pragma once

#include <vector>

#include "draft.h"

namespace roomgen {

/// A thing and what stands around it, as chairs around their table, each with all that stands on
/// it; the thing itself first.
std::vector<Cluster> group_of(const Scene& scene, const Object& leader);

/// All that stands in relations to each other, from the thing on: a seating corner from its sofa to
/// the lamp beside the armchair. What others stand to comes before them.
std::vector<Cluster> related_group_of(const Scene& scene, const Object& thing);
/// Things so that what others stand to comes before them, and the larger before the smaller.
void order_by_relations(std::vector<Cluster>& things);

/// The group as it stands with its leader at another pose.
std::vector<Cluster> moved_to(const std::vector<Cluster>& group, const Pose& pose);

std::set<std::string> ids_of(const std::vector<Cluster>& group);

/// A thing with what stands around it, as they stand to each other, exactly there.
Status move_group_to(Draft& draft, const Object& leader, const Pose& pose);

/// Brings what stood around a thing to where that is now, as it stood to it, or else where its
/// relations hold. `group` is as it was, `moved` is without it but for the leader, and becomes the
/// draft.
Status take_group_along(Draft& draft, Draft& moved, const std::vector<Cluster>& group, const Object& leader);

}  // namespace roomgen
