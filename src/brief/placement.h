#pragma once

#include <optional>

#include "thing_phrase.h"

namespace roomgen::brief {

/// What an attachment says of where something is.
struct SaidPlacement {
  const Placement* placement = nullptr;
  std::int32_t target = language::none;  ///< noun phrase; none: what was spoken of ("to its left")
  bool is_portion = false;               ///< the edge of the target, or another part of it
};

/// The longest phrase of data/words.json that the attachment's words make, with the verb before it
/// ("surrounded by") and the part of a thing behind it ("on each side of"); nothing if it says
/// nothing about a place.
std::optional<SaidPlacement> placement_of(const PromptText& text,
                                          const language::Attachment& attachment);

}  // namespace roomgen::brief
