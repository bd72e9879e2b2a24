#pragma once

#include <string>

#include "chat/interview.h"
#include "roomgen/create/maker.h"

namespace roomgen::create {

/// {"passes": true, "reason": "a chair"}. An error is what to tell the model.
Result<Reading<Verdict>> read_verdict_reply(const std::string& text);

}  // namespace roomgen::create
