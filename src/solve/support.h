#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "layout.h"
#include "roomgen/scene/problem.h"

namespace roomgen {

/// Chooses what a small thing stands on: what its relations say, else what is `wanted` (a category or an
/// id, may be empty), else what usually carries its kind. Passes over as many supports as were `refused`.
/// Sets Object::on, appends the relations by which its kind stands there, and suggests the place of who
/// sits there where that is one of them. Leaves the task as it is when nothing is there to carry it, or
/// when the layout does not know how kinds are arranged.
///
/// Returns where on the support there is room by boxes, if that can be told.
std::optional<Pose> choose_support(const Layout& layout, const std::string& wanted,
                                   std::size_t refused, PlacementTask& task);

}  // namespace roomgen
