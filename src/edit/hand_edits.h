#pragma once

#include <span>

#include "roomgen/edit/session.h"

namespace roomgen {

/// What changed between a scene and its nodes in a file that another program wrote.
Result<HandEdits> read_hand_edits(const Scene& scene, const ModelTable& models, std::span<const SceneNode> nodes);

}  // namespace roomgen
