#pragma once

#include <string>

#include "roomgen/scene/scene.h"
#include "roomgen/scene/object.h"

namespace roomgen::detail {

/// The object's mesh, or its box where there is none, at the object's size in the object's frame.
Mesh sized_mesh(const Object& object, const ModelTable& models);
/// Objects of one key have one sized_mesh(): sizes count to a tenth of a millimetre.
std::string sized_key(const Object& object, const ModelTable& models);

}  // namespace roomgen::detail
