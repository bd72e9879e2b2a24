#pragma once

#include <optional>

#include "roomgen/base/json.h"
#include "roomgen/scene/relation.h"
#include "roomgen/scene/scene.h"
#include "reply_notes.h"
#include "target_names.h"

namespace roomgen::design {

/// Where a thing shall look: a yaw, or at a target when that needs a location that is not known.
struct ReplyFacing {
  std::optional<double> yaw;
  std::optional<Relation> relation;
};

/// Degrees ("90 degrees": counter-clockwise, 0 looks to -y), a point of the compass (+y is north)
/// or a target. Notes what was not understood.
ReplyFacing read_reply_facing(const Json& value, const Scene& scene, const TargetNames& targets,
                              const std::optional<Vec2>& location,
                              ReplyNotes& notes);

}  // namespace roomgen::design
