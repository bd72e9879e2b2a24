#pragma once

#include <string>
#include <vector>

#include "corpus.h"

namespace roomgen::language {

/// Trains the tagger: the bytes that TagModel reads. The same sentences give the same bytes.
std::string train(const std::vector<TaggedSentence>& sentences);

}  // namespace roomgen::language
