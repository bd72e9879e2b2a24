#pragma once

#include <span>

#include "draft.h"
#include "roomgen/edit/session.h"

namespace roomgen {

/// What operations make of a scene.
struct EditedScene {
  Scene scene;
  EditReport report;
};

/// Carries all out, in order, on a copy; checks that nothing invalid came in, and brings the ledger up to
/// date. `earlier` is the scene before the last edit, or null. Of the options what concerns the work counts: repair,
/// seconds, cancel.
Result<EditedScene> edit_scene(Workshop& shop, const Scene& scene, const Scene* earlier,
                               std::span<const edit::Operation> operations, const SessionOptions& options);

/// What a pose would mean.
Result<Preview> preview_pose(Workshop& shop, const Scene& scene, std::string_view object, const WantedPose& pose);

}  // namespace roomgen
