#pragma once

#include <span>

#include "roomgen/scene/room.h"
#include "thing.h"

/// SceneEval's functions of an object to the room (spatial/arch_relation.py, version 1.1.1), each in
/// [0, 1]; a relation holds above one half. Of several walls, doors or windows the best counts.
namespace roomgen::lab::sceneeval {

double inside_room(const Thing& thing, const Room& room);
double middle_of_room(const Thing& thing, const Room& room);
double next_to(const Thing& thing, std::span<const Thing> parts);
double near(const Thing& thing, std::span<const Thing> parts);
double across_from(const Thing& thing, std::span<const Thing> parts);
double far(const Thing& thing, std::span<const Thing> parts);
/// In front of the wall's rectangle and no further than 1 cm.
double on_wall(const Thing& thing, std::span<const Thing> walls);
/// In front of the wall's rectangle and no further than 0.3 m.
double against_wall(const Thing& thing, std::span<const Thing> walls);
/// Near two walls that stand about square to each other, seen from the thing.
double corner_of_room(const Thing& thing, std::span<const Thing> walls, const Room& room);
double hang_from_ceiling(const Thing& thing, const Room& room);

}  // namespace roomgen::lab::sceneeval
