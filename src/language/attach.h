#pragma once

#include <vector>

#include "chunks.h"

namespace roomgen::language {

/// Finds what the chunks of a text are to each other: lists, verbs with their subjects and objects,
/// and what prepositions attach to.
void attach(const std::vector<Chunk>& chunks, Parse& parse);

}  // namespace roomgen::language
