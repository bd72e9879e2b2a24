#pragma once

#include <vector>

#include "parse.h"
#include "tagger.h"

namespace roomgen::language {

/// A piece of a sentence, or the pieces that are one noun phrase.
struct Chunk {
  Tag tag = Tag::noun;           ///< Tag::noun: a noun phrase, pronouns too
  std::uint32_t phrase = 0;      ///< of noun phrases: of Parse::phrases
  const Piece* piece = nullptr;  ///< of everything else
  Run complement;                ///< of adjectives: of Parse::modifiers
};

/// Joins pieces to noun phrases, which go into the parse with their modifiers and measures. The
/// pieces must outlive the chunks.
std::vector<Chunk> chunk(const std::vector<Piece>& pieces, Parse& parse);

/// Finds what the chunks of a text are to each other: lists, verbs with their subjects and objects,
/// and what prepositions attach to.
void attach(const std::vector<Chunk>& chunks, Parse& parse);

}  // namespace roomgen::language
