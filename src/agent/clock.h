#pragma once

#include "roomgen/agent/http_model.h"

namespace roomgen {

/// The machine's time, for what a clock leaves open.
HttpClock completed(HttpClock clock);

}  // namespace roomgen
