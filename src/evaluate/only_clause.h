#pragma once

#include <functional>
#include <string>

#include "roomgen/scene/requirement.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// What is there besides the things of a requirement of Kind::only: of its kind, on one of its targets (or on what
/// stands there), of its mount; of any kind and anywhere where it names none. Empty if nothing is.
std::string other_fault(const Requirement& requirement, const Scene& scene,
                        const std::function<bool(const Object&)>& is_of_kind);

}  // namespace roomgen
