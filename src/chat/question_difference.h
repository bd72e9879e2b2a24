#pragma once

#include <string>
#include <vector>

#include "chat_recording.h"

namespace roomgen {

/// Of the recorded questions, the one that agrees longest with `question` from its beginning; null
/// if there are none.
const RecordedAnswer* nearest_question(const std::vector<RecordedAnswer>& recorded,
                                       const Json& question);

/// Where two questions first differ, with a short excerpt of both: `message 2 (user): recorded "…
/// bed at 1.2", asked "… bed at 1.3"`.
std::string describe_difference(const Json& recorded, const Json& asked);

}  // namespace roomgen
