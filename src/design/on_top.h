#pragma once

#include <string>
#include <vector>

#include "arrangement.h"
#include "roomgen/design/designer.h"
#include "sketch.h"

namespace roomgen::design {

/// Where a small thing goes: on what the plan says (`asked` and `on`), else on what usually carries
/// its kind. `refused` places are passed over.
PlaceAdvice advise_on(const Sketch& sketch, const Object& self, const Arrangement& arrangement,
                      std::vector<Relation> asked, const std::string& on, std::size_t refused);

}  // namespace roomgen::design
