#pragma once

#include "phrase_words.h"

namespace roomgen::brief {

/// What a thing is like: what stands before its name, and what is said of it elsewhere ("made of oak", "is red"). Needs
/// its name.
void read_looks(const PhraseWords& phrase, ThingPhrase& thing);

/// "in pale ash", "of oak": is what a thing is joined to its stuff or its colour?
bool tells_material(const PhraseWords& phrase, const language::Attachment& attachment);

}  // namespace roomgen::brief
