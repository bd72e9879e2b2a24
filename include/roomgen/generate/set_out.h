#pragma once

#include <cstdint>

#include "roomgen/create/create.h"
#include "roomgen/generate/generate.h"

namespace roomgen {

/// Objects that a sentence names together ("a table with cups on it and four chairs around it"), set
/// out by the solver in an empty room: the first in the middle, the others as their relations to it
/// say, as many of each as were asked for. What finds no place is in Generation::scene.unplaced.
Result<Generation> set_out(const create::Creation& creation, const KindTable& categories,
                           std::uint64_t seed);

/// Everything that stands in the scene as one model, the first object's centre at the origin.
Model merged_model(const Scene& scene, const ModelTable& models);

}  // namespace roomgen
