#pragma once

#include <string>
#include <vector>

#include "tag_features.h"

namespace roomgen::language {

/// A sentence of the corpus (data/language/tagged/README.md) as the tagger sees it.
struct TaggedSentence {
  std::string text;
  std::vector<Token> tokens;
  std::vector<Unit> units;
  std::vector<UnitFacts> facts;
  std::vector<WordTag> tags;  ///< of the units
};

/// Reads "word/TAG ..." lines; throws std::runtime_error with the line of what it cannot read.
std::vector<TaggedSentence> read_corpus(const std::string& path);

}  // namespace roomgen::language
