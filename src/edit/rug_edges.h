#pragma once

#include <optional>
#include <span>
#include <string>

#include "roomgen/scene/scene.h"
#include "roomgen/scene/object.h"

namespace roomgen {

/// Rugs, and what stands on the floor and so on rugs or beside them.
bool lies_on_floor(const Object& object);
bool stands_on_floor(const Object& object);

/// Some of the thing's feet are on the rug and some are not.
bool stands_on_edge(const Object& thing, const Object& rug, const ModelTable& models);
/// The height of the rug on which the thing stands, 0 beside all; nothing if it stands on the edge of one.
std::optional<double> height_on_rugs(const Object& thing, std::span<const Object> objects, const ModelTable& models);
/// What stands on the rug's edge, unless it did so as the rug lay `before`; empty if nothing does.
std::string on_edge_of(const Object& rug, const Object* before, std::span<const Object> objects,
                       const ModelTable& models);

}  // namespace roomgen
