#pragma once

#include "destinations.h"

namespace roomgen {

/// Places that words tell by the pose of a thing: "where the lamp is now", "in the place of the chair", "the left edge
/// of the desk", "the foot of the bed". `subjects` shall go there; for what stands on the floor the sides of a thing
/// are relations.
std::optional<Result<Whereabouts>> spot_at(const EditText& text, std::size_t at,
                                           const std::vector<std::string>& subjects);

}  // namespace roomgen
