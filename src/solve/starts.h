#pragma once

#include <optional>

#include "movable.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// The scene with its objects in placement order. Fails when they depend on each other in a circle.
Result<Scene> in_placement_order(Scene scene);

/// The objects of a layout as tasks in placement order, each with those of its constraints that hold there, and
/// their poses.
struct Start {
  std::vector<PlacementTask> tasks;
  Poses poses;
};
Start start_of(const Scene& scene, const KindTable& kinds);

/// Another layout of the same things, found from nothing, in which the same constraints hold; nothing if the search
/// gives up. The layout is empty, and is again in the end.
std::optional<Poses> another_start(Layout& layout, const Start& start, const Random& random, const CancelToken& cancel);

}  // namespace roomgen
