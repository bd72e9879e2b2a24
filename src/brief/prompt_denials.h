#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// Whether an attachment says where something is not: "not next to the window", "none of them in the corner".
bool denies_place(const PromptReading& reading, const language::Attachment& attachment);

/// Enters what it says into the brief: it is known where they are not.
void read_denied_place(PromptReading& reading, const language::Attachment& attachment);

}  // namespace roomgen::brief
