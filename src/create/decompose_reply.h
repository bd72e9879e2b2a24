#pragma once

#include <string>
#include <vector>

#include "chat/interview.h"
#include "roomgen/create/maker.h"

namespace roomgen::create {

/// The objects of a decomposition. What cannot be meant is left out or bounded, and said; an error
/// is what to tell the model. `prompt`: the whole sentence; `kinds`: those that an answer may name.
Result<Reading<std::vector<Description>>> read_decompose_reply(
    const std::string& text, const std::string& prompt, const std::vector<std::string>& kinds);

}  // namespace roomgen::create
