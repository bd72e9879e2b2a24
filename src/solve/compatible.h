#pragma once

#include <vector>

#include "roomgen/scene/relation.h"

namespace roomgen {

/// Does it say where the object is against another thing, so that the object goes where that goes?
bool places(const Relation& relation);

/// The habits that do not contradict what is asked: who is told to stand left of the bed does not
/// stand near the window out of habit, but still at a wall.
std::vector<Relation> compatible_with(const std::vector<Relation>& asked,
                                      const std::vector<Relation>& habits);

}  // namespace roomgen
