#pragma once

#include <vector>

#include "draft.h"

namespace roomgen {

/// A thing with what stands around it, as they stand to each other, exactly there.
Status move_group_to(Draft& draft, const Object& leader, const Pose& pose);

/// Brings what stood around a thing to where that is now, as it stood to it, or else where its relations hold. `group`
/// is as it was, `moved` is without it but for the leader, and becomes the draft.
Status take_group_along(Draft& draft, Draft& moved, const std::vector<Cluster>& group, const Object& leader);

}  // namespace roomgen
