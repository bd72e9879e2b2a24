#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// The word of what is heard as a remark.
inline constexpr const char* said_remark = "remark";

/// What is said of the room as a whole ("a rented flat", "a hall in a mountain village") and of what people do in it
/// ("farmers argue"), where nothing else was made of the words: it is heard and shows in the ledger, but nothing in a
/// room can be judged by it. Comes after all other readers.
void read_remarks(PromptReading& reading);

}  // namespace roomgen::brief
