#pragma once

#include "phrase_words.h"

namespace roomgen::brief {

/// What thing a noun phrase names, known or not, and which of its words say so.
void read_name(const PhraseWords& phrase, ThingPhrase& thing);

/// How many of a thing a noun phrase speaks of, and whether it introduces them. Needs its name.
void read_number(const PhraseWords& phrase, ThingPhrase& thing);

/// What a thing is like: what stands before its name, and what is said of it elsewhere ("made of
/// oak", "is red"). Needs its name.
void read_looks(const PhraseWords& phrase, ThingPhrase& thing);

/// "in pale ash", "of oak": is what a thing is joined to its stuff or its colour?
bool tells_material(const PhraseWords& phrase, const language::Attachment& attachment);

/// How long a thing is said to be: "a 2 m tall bookcase", "a table 1.6 m long", "the desk is 1.6 m
/// wide". Needs its name.
void read_lengths(const PhraseWords& phrase, ThingPhrase& thing);

}  // namespace roomgen::brief
