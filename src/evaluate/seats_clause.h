#pragma once

#include "evaluate/finding.h"
#include "roomgen/scene/requirement.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// Can so many people sit (scene/seats_attribute.h)? A chair or a stool seats one, a wider seat one on each 0.6 m.
Finding judge_seats(const Requirement& requirement, const Scene& scene, const KindTable& kinds);

}  // namespace roomgen
